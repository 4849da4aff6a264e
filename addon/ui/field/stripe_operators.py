# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on the stripes of the field material."""

import bpy

from ...blender.look import material
from ...language import say
from ..common import poll_mesh, reporting


def _poll_stripes(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    from ...blender.look import stripes

    if not poll_mesh(cls, context):
        return False
    if not stripes.find(context.active_object):
        cls.poll_message_set(say("The field's material has no stripes: press Add Stripes first"))
        return False
    return True


class DIRICHLET_OT_add_stripes(bpy.types.Operator):
    bl_idname = "dirichlet.add_stripes"
    bl_label = "Add Stripes"
    bl_description = (
        "Let the field's material draw lines at the levels of the isolines, for renders that need no curves: adds the "
        "node group Dirichlet Stripes to the material"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        if not material.find(context.active_object):
            cls.poll_message_set(say("Solve Field first: the stripes go into its material"))
            return False
        return True

    def execute(self, context):
        from ...blender.look import stripes

        return _run(self, stripes.add, context.active_object)


class DIRICHLET_OT_match_stripes(bpy.types.Operator):
    bl_idname = "dirichlet.match_stripes"
    bl_label = "Match Isolines"
    bl_description = "Move the stripes to the levels that Make Isolines takes now: sets their window, count and phase"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return _poll_stripes(cls, context)

    def execute(self, context):
        from ...blender.look import stripes

        return _run(self, stripes.match, context.active_object)


class DIRICHLET_OT_remove_stripes(bpy.types.Operator):
    bl_idname = "dirichlet.remove_stripes"
    bl_label = "Remove Stripes"
    bl_description = "Take the stripes out of the field's material, which is then as it was before them"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return _poll_stripes(cls, context)

    def execute(self, context):
        from ...blender.look import stripes

        return _run(self, stripes.remove, context.active_object)


def _run(operator: bpy.types.Operator, function, obj: bpy.types.Object) -> set[str]:
    with reporting(operator):
        function(obj)
        return {"FINISHED"}
    return {"CANCELLED"}


CLASSES = (DIRICHLET_OT_add_stripes, DIRICHLET_OT_match_stripes, DIRICHLET_OT_remove_stripes)
