# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that make patches of what the mesh has already, and their menu."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ...blender.names import COLOR
from ..common import poll_mesh
from ..computing import Computing


class _SourceOperator(Computing):
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)


class DIRICHLET_OT_patches_from_borders(_SourceOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patches_from_borders"
    bl_label = "Patches from Borders"
    bl_description = "Add a patch for every border of the mesh: the closed loop of vertices along it"

    def begin(self, objects):
        from ...blender.paint import patch_sources

        return patch_sources.from_borders(objects[0])


class DIRICHLET_OT_patches_from_pieces(_SourceOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patches_from_pieces"
    bl_label = "Patches from Pieces"
    bl_description = (
        "Add a patch for every connected piece of the mesh, the whole piece: one value for each. Leave out pieces by "
        "turning their patches off, or erase paint where the field shall vary"
    )

    def begin(self, objects):
        from ...blender.paint import patch_sources

        return patch_sources.from_pieces(objects[0])


class DIRICHLET_OT_patches_from_attribute(_SourceOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patches_from_attribute"
    bl_label = "Patches from Colors"
    bl_description = (
        "Add a patch for every island of equal value of the active color attribute, or of another one: color, integer, "
        "boolean or float. On corners, edges and faces, vertices where different values meet belong to none"
    )

    attribute: StringProperty(
        name="Attribute", description="Attribute of the mesh whose islands become patches; empty: the active color's"
    )
    background: BoolProperty(
        name="Skip Background",
        description="Make no patches of the most frequent value, the ground",
        default=True,
    )

    _asked = False  # people, for attribute and background

    def invoke(self, context, event):
        self.attribute = self.attribute or _active_color(context.active_object)
        self._asked = True
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        if self._asked:  # by the dialog; what is repeated from the panel of the last operator is repeated at once
            self._asked = False
            return self.work_on(context, self.choose(context))
        return super().execute(context)

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split = True
        column.prop_search(self, "attribute", context.active_object.data, "attributes")
        column.prop(self, "background")

    def begin(self, objects):
        from ...blender.paint import patch_sources

        return patch_sources.from_attribute(objects[0], self.attribute or _active_color(objects[0]), self.background)


class DIRICHLET_MT_patches_from(bpy.types.Menu):
    bl_label = "Patches from"
    bl_description = "Make patches of what the mesh has already"

    def draw(self, context):
        layout = self.layout
        layout.operator("dirichlet.patch_add_selected", text="Selected Vertices", icon="RESTRICT_SELECT_OFF")
        layout.operator("dirichlet.patches_from_borders", text="Border Loops", icon="MESH_CIRCLE")
        layout.operator("dirichlet.patches_from_pieces", text="Connected Pieces", icon="OUTLINER_OB_POINTCLOUD")
        layout.operator("dirichlet.patches_from_attribute", text="Colors or Attribute...", icon="GROUP_VCOL")


def _active_color(obj: bpy.types.Object) -> str:
    """Name of the active colour attribute; empty when there is none but the field's."""
    name = obj.data.color_attributes.active_color_name
    return "" if name == COLOR else name


CLASSES = (
    DIRICHLET_OT_patches_from_borders,
    DIRICHLET_OT_patches_from_pieces,
    DIRICHLET_OT_patches_from_attribute,
    DIRICHLET_MT_patches_from,
)
