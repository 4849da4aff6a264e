# SPDX-License-Identifier: GPL-3.0-or-later
"""The sub-panel Preview of the panel Isolines."""

import bpy


class DIRICHLET_PT_preview(bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Isolines"
    bl_parent_id = "DIRICHLET_PT_isolines"
    bl_label = "Preview"

    def draw_header(self, context):
        self.layout.prop(context.active_object.dirichlet, "preview", text="")

    def draw(self, context):
        layout, settings = self.layout, context.active_object.dirichlet
        layout.use_property_split = True
        layout.use_property_decorate = False
        lines = layout.column()
        lines.active = settings.preview
        lines.prop(settings, "preview_width")
        lines.prop(settings, "preview_xray")
        layout.prop(settings, "legend")
        if context.mode == "PAINT_WEIGHT":  # whose colours cover the field's
            layout.prop(context.space_data.overlay, "weight_paint_mode_opacity", text="Weights")


CLASSES = (DIRICHLET_PT_preview,)
