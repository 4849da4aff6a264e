# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh data-blocks as arrays, and arrays as attributes of theirs."""
