# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that make patches of what the mesh has already, and their menu."""

import bpy
from bpy.props import BoolProperty, StringProperty

from ... import library
from ...blender.names import COLOR
from ...language import counted
from ..common import poll_mesh


class _SourceOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def add(self, context, name: str, find) -> set[str]:
        """A patch named so for every set of vertices that `find` returns of the object."""
        from ...blender.paint import patches

        obj = context.active_object
        try:
            sets = find(obj)
        except library.refusals() as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for vertices in sets:
            patches.add_group(obj, name, vertices)
        self.report({"INFO"}, counted(len(sets), "1 patch added", "{count} patches added"))
        return {"FINISHED"}


class DIRICHLET_OT_patches_from_borders(_SourceOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patches_from_borders"
    bl_label = "Patches from Borders"
    bl_description = "Add a patch for every border of the mesh: the closed loop of vertices along it"

    def execute(self, context):
        from ...blender.paint import patch_sources

        return self.add(context, "Border", patch_sources.border_loops)


class DIRICHLET_OT_patches_from_pieces(_SourceOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patches_from_pieces"
    bl_label = "Patches from Pieces"
    bl_description = (
        "Add a patch for every connected piece of the mesh, the whole piece: one value for each. Leave out pieces by "
        "turning their patches off, or erase paint where the field shall vary"
    )

    def execute(self, context):
        from ...blender.paint import patch_sources

        return self.add(context, "Piece", patch_sources.pieces)


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

    def invoke(self, context, event):
        self.attribute = self.attribute or _active_color(context)
        return context.window_manager.invoke_props_dialog(self)

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split = True
        column.prop_search(self, "attribute", context.active_object.data, "attributes")
        column.prop(self, "background")

    def execute(self, context):
        from ...blender.paint import patch_sources

        name = self.attribute or _active_color(context)
        # not the attribute's own name, which would then stand for both
        return self.add(
            context, f"{name} island", lambda obj: patch_sources.attribute_islands(obj, name, self.background)
        )


class DIRICHLET_MT_patches_from(bpy.types.Menu):
    bl_label = "Patches from"
    bl_description = "Make patches of what the mesh has already"

    def draw(self, context):
        layout = self.layout
        layout.operator("dirichlet.patch_add_selected", text="Selected Vertices", icon="RESTRICT_SELECT_OFF")
        layout.operator("dirichlet.patches_from_borders", text="Border Loops", icon="MESH_CIRCLE")
        layout.operator("dirichlet.patches_from_pieces", text="Connected Pieces", icon="OUTLINER_OB_POINTCLOUD")
        layout.operator("dirichlet.patches_from_attribute", text="Colors or Attribute...", icon="GROUP_VCOL")


def _active_color(context: bpy.types.Context) -> str:
    """Name of the active colour attribute; empty when there is none but the field's."""
    name = context.active_object.data.color_attributes.active_color_name
    return "" if name == COLOR else name


CLASSES = (
    DIRICHLET_OT_patches_from_borders,
    DIRICHLET_OT_patches_from_pieces,
    DIRICHLET_OT_patches_from_attribute,
    DIRICHLET_MT_patches_from,
)
