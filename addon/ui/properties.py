# SPDX-License-Identifier: GPL-3.0-or-later
"""What an object remembers: patches, settings, results. All of it is saved with the file."""

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import callbacks
from .result_properties import DirichletResults


class DirichletPatch(bpy.types.PropertyGroup):
    """A painted patch: a vertex group and the value prescribed on it."""

    group: StringProperty(name="Vertex Group", description="Vertex group whose vertices form the patch")
    value: FloatProperty(
        name="Value",
        description="Value of the field on the patch, kept exactly",
        precision=3,
    )
    enabled: BoolProperty(
        name="Enabled", description="Take part in the next solve; off leaves the patch free", default=True
    )
    weights_as_values: BoolProperty(
        name="Weights as Values",
        description="Take each vertex's weight as its value, instead of one value for the patch. The patch is then "
        "every vertex with a weight above 0, whatever the threshold",
    )


class DirichletSettings(bpy.types.PropertyGroup):
    """Object.dirichlet"""

    patches: CollectionProperty(type=DirichletPatch, name="Patches", description="Painted patches of this object")
    active_patch: IntProperty(name="Active Patch", description="Selected row of the list of patches")
    threshold: FloatProperty(
        name="Threshold",
        description="A vertex belongs to a patch when its weight in the group is at least this, and above 0",
        default=0.5,
        min=0.0,
        max=1.0,
    )
    overlap: EnumProperty(
        name="Overlap",
        description="Value of a vertex that several patches give different values",
        items=(
            ("error", "Is an Error", "Refuse to solve, and name the vertex and both groups"),
            ("first", "First in List", "The value of the first of these patches in the list"),
            ("highest", "Highest", "The highest of the values"),
            ("average", "Average", "The average of the values"),
        ),
    )
    method: EnumProperty(
        name="Method",
        description="How the linear system is solved",
        items=(
            ("auto", "Automatic", "Direct while the factorisation fits into half of the memory, else Multigrid"),
            ("direct", "Direct", "Cholesky factorisation of the symmetric form: fast and exact to rounding"),
            ("multigrid", "Multigrid", "Conjugate gradients with little memory, to a relative residual of 1e-10: for "
             "meshes of many millions of vertices"),
            ("lscg", "Least Squares", "Least-squares conjugate gradients on the unsymmetric matrix, as in the paper: "
             "a slow reference"),
        ),
    )  # fmt: skip
    ramp_preset: EnumProperty(
        name="Ramp",
        description="Colours for values from low to high. Choosing one replaces the stops of the ramp below",
        items=(
            ("rainbow", "Rainbow", "Blue, cyan, green, yellow, red: the paper's"),
            ("viridis", "Viridis", "Dark violet to yellow: even steps to the eye, readable in grey"),
            ("grey", "Grey", "Black to white"),
            ("red-blue", "Red-Blue", "Red over white to blue: tells both sides of the middle apart"),
        ),
        update=callbacks.ramp_preset_changed,
    )
    levels_mode: EnumProperty(
        name="Levels",
        description="How the values of the isolines are chosen",
        items=(
            ("EVEN", "Even", "So many levels, spread evenly inside the window"),
            ("STEP", "Step", "Multiples of a step inside the window, shifted by a phase"),
            ("LIST", "List", "The values listed"),
        ),
    )
    count: IntProperty(
        name="Count", description="Number of levels inside the window", default=13, soft_min=1, soft_max=1000
    )
    window_auto: BoolProperty(
        name="Whole Range",
        description="The window is the whole range of the field; off takes the low and high end set here",
        default=True,
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
        description="Where the window's lower end stands on the ramp above: 0 is its left end, 1 its right end",
        subtype="FACTOR",
        min=0.0,
        max=1.0,
        get=callbacks.get_window_low_place,
        set=callbacks.set_window_low_place,
    )
    window_high_place: FloatProperty(
        name="Window High",
        description="Where the window's upper end stands on the ramp above: 0 is its left end, 1 its right end",
        subtype="FACTOR",
        min=0.0,
        max=1.0,
        get=callbacks.get_window_high_place,
        set=callbacks.set_window_high_place,
    )
    step: FloatProperty(
        name="Step", description="Difference between neighbouring levels", default=0.1, soft_min=0.0, precision=4
    )
    phase: FloatProperty(
        name="Phase",
        description="Shift of the levels in steps: animate it from 0 to 1 and every line moves to its neighbour",
        soft_min=0.0,
        soft_max=1.0,
    )
    levels_list: StringProperty(
        name="Levels", description="Values of the isolines, between commas or spaces, such as 0.1, 0.25, 0.5"
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
    isolines: PointerProperty(
        type=bpy.types.Object,
        name="Isolines",
        description="Curve object with the isolines of this object; Make Isolines updates it. Clear its parent to keep "
        "it as it is: the next run then makes another",
    )
    results: PointerProperty(
        type=DirichletResults, name="Results", description="What the last solve and the last isolines measured"
    )


CLASSES = (DirichletPatch, DirichletResults, DirichletSettings)
