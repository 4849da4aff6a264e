# SPDX-License-Identifier: GPL-3.0-or-later
"""What an object remembers: patches, settings, results. All of it is saved with the file."""

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import callbacks
from .drawing.preview_properties import PreviewSettings
from .field.laplacians import LAPLACIANS
from .lines.line_properties import LineSettings
from .result_properties import DirichletResults

RAMPS = (
    ("rainbow", "Rainbow", "Blue, cyan, green, yellow, red: the paper's"),
    ("viridis", "Viridis", "Dark violet to yellow: even steps to the eye, readable in grey"),
    ("grey", "Grey", "Black to white"),
    ("red-blue", "Red-Blue", "Red over white to blue: tells both sides of the middle apart"),
)


class DirichletPatch(bpy.types.PropertyGroup):
    """A painted patch: a vertex group and the value prescribed on it."""

    group: StringProperty(
        name="Vertex Group",
        description="Vertex group whose vertices form the patch",
        update=callbacks.painting_changed,
    )
    value: FloatProperty(
        name="Value",
        description="Value of the field on the patch, kept exactly",
        precision=3,
        update=callbacks.painting_changed,
    )
    enabled: BoolProperty(
        name="Enabled",
        description="Take part in the next solve; off leaves the patch free",
        default=True,
        update=callbacks.painting_changed,
    )
    weights_as_values: BoolProperty(
        name="Weights as Values",
        description="Take each vertex's weight as its value, instead of one value for the patch. The patch is then "
        "every vertex with a weight above 0, whatever the threshold",
        update=callbacks.painting_changed,
    )
    color: FloatVectorProperty(
        name="Color",
        description="Color of the patch's value on the ramp",
        subtype="COLOR",
        size=3,
        min=0.0,
        max=1.0,
        get=callbacks.get_patch_color,
        options={"SKIP_SAVE"},
    )
    vertices: IntProperty(name="Vertices", description="Vertices of the patch when it was last solved for or checked")
    problem: StringProperty(
        name="Problem", description="What keeps the patch from being one disc apart from all others; empty for nothing"
    )


class DirichletSettings(LineSettings, PreviewSettings, bpy.types.PropertyGroup):
    """Object.dirichlet"""

    patches: CollectionProperty(type=DirichletPatch, name="Patches", description="Painted patches of this object")
    active_patch: IntProperty(
        name="Active Patch", description="Selected row of the list of patches", options={"SKIP_SAVE"}
    )
    threshold: FloatProperty(
        name="Threshold",
        description="A vertex belongs to a patch when its weight in the group is at least this, and above 0",
        default=0.5,
        min=0.0,
        max=1.0,
        update=callbacks.painting_changed,
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
        update=callbacks.painting_changed,
    )
    disc_size: FloatProperty(
        name="Disc Size",
        description="Radius of the next disc that Add Patch adds, as a fraction of the diagonal of the object's "
        "bounding box",
        default=0.05,
        min=0.0,
    )
    disc_radius: FloatProperty(
        name="Radius",
        description="Radius along the surface of the next disc that Add Patch adds, before the object is scaled. "
        "Dragging sets it",
        subtype="DISTANCE",
        min=0.0,
        precision=4,
        options={"SKIP_SAVE"},  # Disc Size is what meshes of other sizes take
        get=callbacks.get_disc_radius,
        set=callbacks.set_disc_radius,
    )
    laplacian: EnumProperty(
        name="Laplacian",
        description="What the field is smooth by: by which vertices are neighbors alone, or by the shape of the faces",
        items=LAPLACIANS,
        update=callbacks.painting_changed,
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
        update=callbacks.painting_changed,
    )  # fmt: skip
    ramp_preset: EnumProperty(
        name="Ramp",
        description="Colours for values from low to high. Choosing one replaces the stops of the ramp below",
        items=RAMPS,
        update=callbacks.ramp_preset_changed,
    )
    ramp_stops: StringProperty(
        name="Ramp Stops",
        description="Stops that the ramp begins with in place of the chosen ramp's, as a preset brought them: JSON "
        "with color_mode, interpolation, hue_interpolation and stops of place, red, green, blue and alpha",
        update=callbacks.ramp_stops_changed,
    )
    live: BoolProperty(
        name="Live",
        description="Field, colours and lines follow the brush, the patches' values and every other setting. Off, they "
        "wait for Solve Field and Make Isolines",
        options={"SKIP_SAVE"},  # copied or brought by a preset, it would compute at once
        update=callbacks.live_changed,
    )
    use_modifiers: BoolProperty(
        name="Use Modifiers",
        description="Solve and draw on the shape that armature, shape keys and modifiers give the mesh, by the weights "
        "that those leave. They have to keep its faces",
        update=callbacks.painting_changed,
    )
    followed: BoolProperty(
        name="Followed", description="Isolines of this object were set to Follow", options={"SKIP_SAVE"}
    )
    preview: BoolProperty(
        name="Preview",
        description="Draw the isolines in the viewport at once, without making an object. They are not rendered. Where "
        "a result shows the same lines as tubes, it is seen alone",
        update=callbacks.preview_changed,
    )
    isolines: PointerProperty(
        type=bpy.types.Object,
        name="Isolines",
        description="Object with the isolines of this one; Make Isolines updates it. Lock it or clear its parent to "
        "keep it as it is: the next run then makes another",
    )
    results: PointerProperty(
        type=DirichletResults, name="Results", description="What the last solve and the last isolines measured"
    )


CLASSES = (DirichletPatch, DirichletResults, DirichletSettings)
