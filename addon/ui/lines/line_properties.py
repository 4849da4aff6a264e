# SPDX-License-Identifier: GPL-3.0-or-later
"""How isolines are chosen and drawn."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from .. import callbacks
from .shape_properties import ShapeSettings

_OUTPUTS = (
    ("CURVE", "Curve", "A curve object with a material per level. In geometry nodes (Object Info) and after conversion "
     "the level of a line is its points' tilt; Is Spline Cyclic and Spline Length tell the rest. The curve itself has "
     "custom properties dirichlet_level, dirichlet_closed and dirichlet_length, one number per spline"),
    ("MESH", "Mesh Edges", "A mesh of edges, for geometry nodes (Mesh to Curve), with attributes per point: "
     "dirichlet_level, dirichlet_closed, dirichlet_length, dirichlet_line (its number), dirichlet_color and radius"),
    ("CURVES", "Curves", "The curves of geometry nodes and hair, with attributes per curve: dirichlet_level, "
     "dirichlet_closed, dirichlet_length, dirichlet_line (its number) and dirichlet_color; per point: radius"),
)  # fmt: skip
_CAN_MAKE_CURVES = "set_types" in bpy.types.Curves.bl_rna.functions


class LineSettings(ShapeSettings):
    """What every set of isolines is made by; a part of the PropertyGroups that have one."""

    levels_mode: EnumProperty(
        name="Levels",
        description="How the values of the isolines are chosen",
        items=(
            ("EVEN", "Even", "So many levels, spread evenly inside the window"),
            ("STEP", "Step", "Multiples of a step inside the window, shifted by a phase"),
            ("LIST", "List", "The values listed"),
            ("EQUAL_AREA", "Equal Areas", "So many levels, which cut the surface into strips of equal areas"),
            (
                "EQUAL_DISTANCE",
                "Equal Distances",
                "So many levels, from one of which to the next lines advance equally far on the surface, on average",
            ),
        ),
        update=callbacks.lines_changed,
    )
    count: IntProperty(
        name="Count",
        description="Number of levels inside the window",
        default=13,
        soft_min=1,
        soft_max=1000,
        update=callbacks.lines_changed,
    )
    window_auto: BoolProperty(
        name="Whole Range",
        description="The window is the whole range of the field; off takes the low and high end set here",
        default=True,
        update=callbacks.window_auto_changed,
    )
    window_low: FloatProperty(
        name="Low",
        description="Lower end of the window of values that levels are chosen in",
        precision=4,
        update=callbacks.window_low_changed,
    )
    window_high: FloatProperty(
        name="High",
        description="Upper end of the window of values that levels are chosen in",
        default=1.0,
        precision=4,
        update=callbacks.window_high_changed,
    )
    window_low_place: FloatProperty(
        name="Window Low",
        description="Where the window's lower end stands on the ramp above: 0 is its left end, 1 its right end. To "
        "animate the window, put keyframes on Low and High",
        subtype="FACTOR",
        min=0.0,
        max=1.0,
        options={"SKIP_SAVE"},  # Low and High are what is animated
        get=callbacks.get_window_low_place,
        set=callbacks.set_window_low_place,
    )
    window_high_place: FloatProperty(
        name="Window High",
        description="Where the window's upper end stands on the ramp above: 0 is its left end, 1 its right end. To "
        "animate the window, put keyframes on Low and High",
        subtype="FACTOR",
        min=0.0,
        max=1.0,
        options={"SKIP_SAVE"},  # Low and High are what is animated
        get=callbacks.get_window_high_place,
        set=callbacks.set_window_high_place,
    )
    window_place: FloatProperty(
        name="Slide Window",
        description="Moves both ends of the window along the ramp above: 0 is at its left end, 1 at its right end",
        subtype="FACTOR",
        min=0.0,
        max=1.0,
        options={"SKIP_SAVE"},
        get=callbacks.get_window_place,
        set=callbacks.set_window_place,
    )
    step: FloatProperty(
        name="Step",
        description="Difference between neighbouring levels",
        default=0.1,
        soft_min=0.0,
        precision=4,
        update=callbacks.lines_changed,
    )
    phase: FloatProperty(
        name="Phase",
        description="Shift of the levels in steps: animate it from 0 to 1 and every line moves to its neighbour",
        soft_min=0.0,
        soft_max=1.0,
        update=callbacks.lines_changed,
    )
    levels_list: StringProperty(
        name="Levels",
        description="Values of the isolines, between commas or spaces, such as 0.1, 0.25, 0.5",
        update=callbacks.lines_changed,
    )
    bevel_depth: FloatProperty(
        name="Thickness",
        description="Radius of the isolines' tubes, as a fraction of the diagonal of the mesh's bounding box",
        default=0.002,
        min=0.0,
        soft_max=0.02,
        precision=4,
        step=0.02,
        update=callbacks.bevel_depth_changed,
    )
    output: EnumProperty(
        name="Output",
        description="What the isolines are written as. A change replaces the object when they are next made, with its "
        "name, parent, collections and transform",
        items=_OUTPUTS if _CAN_MAKE_CURVES else _OUTPUTS[:2],
        update=callbacks.lines_changed,
    )
