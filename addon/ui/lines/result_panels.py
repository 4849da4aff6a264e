# SPDX-License-Identifier: GPL-3.0-or-later
"""A result's panel: in its Data tab, and in the sidebar while it is active."""

import bpy

from ...blender.lines import result_objects
from ...language import label, say
from ..common import write_sentence
from .line_layout import draw_line_settings, draw_lock, properties


class _ResultPanel:
    bl_label = "Dirichlet Isolines"

    @classmethod
    def poll(cls, context):
        return context.object is not None and result_objects.is_result(context.object)

    def draw(self, context):
        _draw_result(self.layout, context)


class DIRICHLET_PT_result_data(_ResultPanel, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "data"


class DIRICHLET_PT_result_sidebar(_ResultPanel, bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Isolines"


def _draw_result(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    result = context.object
    note, source = result.dirichlet_isolines, result_objects.find_source(result)
    settings = result_objects.settings_of(result, source)
    if source is None:
        write_sentence(
            layout, context, say("The mesh object of these isolines is gone: choose another as Source"), "INFO"
        )
    row = layout.row(align=True)
    row.operator("dirichlet.result_refresh", icon="FILE_REFRESH")
    draw_lock(row, note)
    column = layout.column(align=True)
    column.operator("dirichlet.result_select_source", icon="RESTRICT_SELECT_OFF")
    column.operator("dirichlet.result_remove", icon="X")
    column = properties(layout)
    column.enabled = not note.locked
    column.prop(note, "source")
    column.prop(note, "follow")
    box = layout.column()
    box.enabled = not note.locked
    whose = label("Settings of its own")
    if settings != note:
        whose = label("Settings of '{object}'", object=source.name)
    box.label(text=whose, translate=False, icon="LINKED" if settings != note else "UNLINKED")
    draw_line_settings(box, settings)


CLASSES = (DIRICHLET_PT_result_data, DIRICHLET_PT_result_sidebar)
