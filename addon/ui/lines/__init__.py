# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines and their results."""
