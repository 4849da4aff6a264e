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


_registered: list[type] = []


def register() -> None:
    if bpy.context.window_manager.keyconfigs.addon is None:  # while Blender starts without a window
        return
    for tool in _TOOLS:
        bpy.utils.register_tool(tool, separator=True)
        _registered.append(tool)


def unregister() -> None:
    while _registered:
        bpy.utils.unregister_tool(_registered.pop())
