# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's preferences."""

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty

from ..blender import preferences
from ..blender.preferences import DEFAULTS
from .properties import RAMPS


class DirichletPreferences(bpy.types.AddonPreferences):
    bl_idname = preferences.PACKAGE

    ramp: EnumProperty(
        name="Ramp", description="Ramp of objects that get their first patch", items=RAMPS, default=DEFAULTS.ramp
    )
    live_delay: FloatProperty(
        name="Live Delay",
        description="Seconds between the last change and the update of a live field",
        default=DEFAULTS.live_delay,
        min=0.0,
        soft_max=2.0,
        subtype="TIME_ABSOLUTE",
    )
    ask_vertices: IntProperty(
        name="Ask from Vertices",
        description="Solve Field and Make Isolines ask first on meshes of this many vertices or more",
        default=DEFAULTS.ask_vertices,
        min=1,
    )
    memory_budget: IntProperty(
        name="Memory Budget",
        description="Megabytes for a factorisation and what makes strokes quick; 0: half of the machine's memory. "
        "The automatic method turns to multigrid for what needs more",
        default=DEFAULTS.memory_budget,
        min=0,
    )

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split = True
        for name in vars(DEFAULTS):
            column.prop(self, name)


CLASSES = (DirichletPreferences,)
