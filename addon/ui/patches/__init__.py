# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of patches, and the tools that add to it."""
