# SPDX-License-Identifier: GPL-3.0-or-later
"""The sub-panel Shape of Lines: of the mesh object, and of a result in its Data tab and in the sidebar."""

import bpy

from ...blender.lines import result_objects
from .line_layout import draw_line_shape


class _ShapePanel:
    bl_label = "Shape of Lines"
    bl_options = {"DEFAULT_CLOSED"}


class _ResultShapePanel(_ShapePanel):
    def draw(self, context):
        result = context.object
        self.layout.enabled = not result.dirichlet_isolines.locked
        draw_line_shape(self.layout, result_objects.settings_of(result, result_objects.find_source(result)))


class DIRICHLET_PT_shape(_ShapePanel, bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Isolines"
    bl_parent_id = "DIRICHLET_PT_isolines"

    def draw(self, context):
        draw_line_shape(self.layout, context.active_object.dirichlet)


class DIRICHLET_PT_result_data_shape(_ResultShapePanel, bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "data"
    bl_parent_id = "DIRICHLET_PT_result_data"


class DIRICHLET_PT_result_sidebar_shape(_ResultShapePanel, bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Isolines"
    bl_parent_id = "DIRICHLET_PT_result_sidebar"


CLASSES = (DIRICHLET_PT_shape, DIRICHLET_PT_result_data_shape, DIRICHLET_PT_result_sidebar_shape)
