# SPDX-License-Identifier: GPL-3.0-or-later
"""What is painted: vertex groups as patches, and where patches come from."""
