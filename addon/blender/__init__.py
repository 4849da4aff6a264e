# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender's data-blocks and arrays: the only room of the add-on that touches data-blocks."""
