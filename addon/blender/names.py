# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that users and other add-ons find our data by."""

FIELD = "dirichlet_field"  # FLOAT per point: the true values, NaN where undefined
COLOR = "dirichlet_color"  # FLOAT_COLOR per point

# Of isolines: custom properties of a legacy curve (one number per spline, in their order), else attributes.
LEVEL = "dirichlet_level"
CLOSED = "dirichlet_closed"
LENGTH = "dirichlet_length"  # in object space
LINE = "dirichlet_line"  # number of the line; of attributes alone
