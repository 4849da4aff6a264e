# SPDX-License-Identifier: GPL-3.0-or-later
"""How lines and field are shown in the 3D viewports."""

from bpy.props import BoolProperty, FloatProperty


class PreviewSettings:
    """A part of Object.dirichlet."""

    preview_width: FloatProperty(
        name="Width",
        description="Width of the previewed lines in pixels, whatever the distance",
        subtype="PIXEL",
        default=2.0,
        min=1.0,
        soft_max=8.0,
        max=32.0,
        precision=1,
        step=50,
    )
    preview_xray: BoolProperty(
        name="X-Ray", description="Show the previewed lines through surfaces, also where they are hidden"
    )
    legend: BoolProperty(
        name="Legend",
        description="Show the ramp with the field's range, the window and the levels at the side of the 3D viewports, "
        "while this object is active",
    )
