# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the selected row of the list of patches."""

import bpy
from bpy.props import EnumProperty, IntProperty

from ...language import say
from .. import callbacks
from ..common import poll_mesh, poll_patch
from ..computing import Computing


class _RowOperator:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context) and poll_patch(cls, context)


class DIRICHLET_OT_patch_remove(_RowOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patch_remove"
    bl_label = "Remove Patch"
    bl_description = "Remove the selected patch from the list; its vertex group stays"

    def execute(self, context):
        from ...blender.paint import patches

        patches.remove(context.active_object)
        callbacks.painting_changed(context.active_object.dirichlet, context)
        return {"FINISHED"}


class DIRICHLET_OT_patch_move(_RowOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patch_move"
    bl_label = "Move Patch"
    bl_description = (
        "Move the selected patch in the list. The order decides how Spread Values spreads, and which patch is the first"
    )

    direction: EnumProperty(
        name="Direction",
        description="Where the patch goes in the list",
        items=(("UP", "Up", "One row up"), ("DOWN", "Down", "One row down")),
    )

    def execute(self, context):
        from ...blender.paint import patches

        moved = patches.move(context.active_object, -1 if self.direction == "UP" else 1)
        if not moved:
            return {"CANCELLED"}
        callbacks.painting_changed(context.active_object.dirichlet, context)
        return {"FINISHED"}


class DIRICHLET_OT_patch_duplicate(_RowOperator, bpy.types.Operator):
    bl_idname = "dirichlet.patch_duplicate"
    bl_label = "Duplicate Patch"
    bl_description = "Add a copy of the selected patch, with a copy of its vertex group"

    def execute(self, context):
        from ...blender.paint import patches

        obj = context.active_object
        group = obj.dirichlet.patches[obj.dirichlet.active_patch].group
        if group not in obj.vertex_groups:
            self.report(
                {"ERROR"},
                say(
                    "Object '{object}' has no vertex group '{group}': pick one below the list first",
                    object=obj.name,
                    group=group,
                ),
            )
            return {"CANCELLED"}
        patches.duplicate(obj)
        return {"FINISHED"}


class DIRICHLET_OT_check_patches(Computing, bpy.types.Operator):
    bl_idname = "dirichlet.check_patches"
    bl_label = "Check Patches"
    bl_description = "Count the vertices of every patch, and see whether each is a disc that overlaps no other"
    bl_options = {"REGISTER", "UNDO"}

    index: IntProperty(
        name="Patch",
        description="Row whose explanation the button shows; all are checked",
        default=-1,
        options={"HIDDEN"},
    )

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    @classmethod
    def description(cls, context, properties):
        patches = context.active_object.dirichlet.patches if context.active_object else ()
        if 0 <= properties.index < len(patches):
            return say("{problem}. Click to check again", problem=patches[properties.index].problem)
        return say(cls.bl_description)

    def begin(self, objects):
        from ...blender.paint import patches

        return patches.check(objects[0])


CLASSES = (
    DIRICHLET_OT_patch_remove,
    DIRICHLET_OT_patch_move,
    DIRICHLET_OT_patch_duplicate,
    DIRICHLET_OT_check_patches,
)
