# SPDX-License-Identifier: GPL-3.0-or-later
"""How a field looks: its material, the ramp in it, stripes."""
