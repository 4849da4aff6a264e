# SPDX-License-Identifier: GPL-3.0-or-later
"""The sub-panel Stripes of the panel Isolines."""

import bpy


class DIRICHLET_PT_stripes(bpy.types.Panel):
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Isolines"
    bl_parent_id = "DIRICHLET_PT_isolines"
    bl_label = "Stripes"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        from ...blender.look import stripes

        layout, node = self.layout, stripes.find(context.active_object)
        if not node:
            layout.operator("dirichlet.add_stripes", icon="NODE_TEXTURE")
            return
        layout.operator("dirichlet.match_stripes", icon="FILE_REFRESH")
        column = layout.column()
        column.use_property_split = True  # with the dots that set keyframes
        color = stripes.find_color(context.active_object)
        if color:
            column.prop(color, "default_value", text="Color")
        for socket in node.inputs:
            column.prop(socket, "default_value", text=socket.name)
        layout.operator("dirichlet.remove_stripes", icon="X")


CLASSES = (DIRICHLET_PT_stripes,)
