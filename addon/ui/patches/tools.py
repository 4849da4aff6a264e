# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools in the toolbar of the 3D viewport."""

import bpy

ADD_PATCH = "dirichlet.add_patch"


class _AddPatch:
    bl_space_type = "VIEW_3D"
    bl_idname = ADD_PATCH
    bl_label = "Add Patch"
    bl_description = (
        "Add disc patches to the active mesh: press on its surface, drag for the radius, release. Works in Object and "
        "Weight Paint mode"
    )
    bl_icon = "ops.gpencil.primitive_circle"
    bl_keymap = (("dirichlet.add_patch_disc", {"type": "LEFTMOUSE", "value": "PRESS"}, None),)

    @staticmethod
    def draw_settings(context, layout, tool):
        obj = context.active_object
        if obj and obj.type == "MESH":
            layout.prop(obj.dirichlet, "disc_radius")
        else:
            layout.label(text="Select a mesh object first", icon="INFO")


class AddPatchInObjectMode(_AddPatch, bpy.types.WorkSpaceTool):
    bl_context_mode = "OBJECT"


class AddPatchInWeightPaint(_AddPatch, bpy.types.WorkSpaceTool):
    bl_context_mode = "PAINT_WEIGHT"


_TOOLS = (AddPatchInObjectMode, AddPatchInWeightPaint)


def register() -> None:
    for tool in _TOOLS:
        bpy.utils.register_tool(tool, separator=True)


def unregister() -> None:
    for tool in reversed(_TOOLS):
        bpy.utils.unregister_tool(tool)
