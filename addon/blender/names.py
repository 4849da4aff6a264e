# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that users and other add-ons find our data by."""

FIELD = "dirichlet_field"  # FLOAT per point: the true values, NaN where undefined
COLOR = "dirichlet_color"  # FLOAT_COLOR per point

# Custom properties of the isolines' curve data: one number per spline, in the order of the splines.
LEVEL = "dirichlet_level"
CLOSED = "dirichlet_closed"
LENGTH = "dirichlet_length"  # in object space
