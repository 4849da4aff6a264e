# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's preferences."""

from contextlib import suppress

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty

from .. import library
from ..blender import preferences
from ..blender.preferences import DEFAULTS
from .common import write_sentence
from .properties import RAMPS


def _threads_changed(_preferences, _context) -> None:
    with suppress(library.LibraryMissingError):  # the preferences themselves say so
        preferences.limit_threads()


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
    threads: IntProperty(
        name="Threads",
        description="Threads that compute; 0: one per processor",
        default=DEFAULTS.threads,
        min=0,
        update=_threads_changed,
    )
    memory_budget: IntProperty(
        name="Memory Budget (MB)",
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
        self.layout.separator()
        _draw_build(self.layout, context)


def _draw_build(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """How the compiled library was built, or why there is none."""
    try:
        information = library.load().build_information()
    except library.LibraryMissingError as error:
        write_sentence(layout, context, str(error), "ERROR")
        return
    column = layout.column(align=True)
    column.label(text="Compiled Library", icon="INFO")
    for name, text in information.items():
        row = column.split(factor=0.4)
        names = row.row()
        names.alignment = "RIGHT"
        names.label(text=name.replace("_", " "), translate=False)
        row.label(text=text, translate=False)


CLASSES = (DirichletPreferences,)
