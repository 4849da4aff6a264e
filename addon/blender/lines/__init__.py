# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines: their levels, their shape, and the objects that they are written into."""
