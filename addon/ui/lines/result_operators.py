# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on a result: the active object, or that of the Properties editor."""

import bpy

from ...blender.lines import result_objects
from ...language import say
from ..common import is_local
from ..computing import Computing


class DIRICHLET_OT_result_refresh(Computing, bpy.types.Operator):
    bl_idname = "dirichlet.result_refresh"
    bl_label = "Refresh"
    bl_description = (
        "Make these isolines anew from the field that their mesh object has now, by the settings shown below; and so "
        "all other selected ones that are not locked"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not _poll_source(cls, context):
            return False
        if context.object.dirichlet_isolines.locked:
            cls.poll_message_set(say("These isolines are locked: switch off Lock first"))
            return False
        return True

    def choose(self, context):
        others = [obj for obj in context.selected_objects if obj != context.object and _can_be_refreshed(obj)]
        return [context.object, *sorted(others, key=lambda obj: obj.name)]

    def begin(self, objects):
        from ...blender import several

        return several.refresh(objects)

    def sources(self, objects):
        return [obj.dirichlet_isolines.source for obj in objects]


class DIRICHLET_OT_result_remove(bpy.types.Operator):
    bl_idname = "dirichlet.result_remove"
    bl_label = "Remove"
    bl_description = "Remove these isolines: object, data and materials made for them. Their mesh object becomes active"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return _poll_result(cls, context)

    def execute(self, context):
        result = context.object
        source = result_objects.find_source(result)
        if source:
            _activate(context, source)
        result_objects.remove(result)
        return {"FINISHED"}


class DIRICHLET_OT_result_select_source(bpy.types.Operator):
    bl_idname = "dirichlet.result_select_source"
    bl_label = "Select Source"
    bl_description = "Select the mesh object that these isolines were made of, and make it active"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not _poll_source(cls, context):
            return False
        if context.object.dirichlet_isolines.source.name not in context.view_layer.objects:
            cls.poll_message_set(say("The mesh object is not in this view layer"))
            return False
        return True

    def execute(self, context):
        _activate(context, context.object.dirichlet_isolines.source)
        return {"FINISHED"}


def _can_be_refreshed(obj: bpy.types.Object) -> bool:
    if not result_objects.is_result(obj) or not result_objects.find_source(obj):
        return False
    return not obj.dirichlet_isolines.locked and is_local(obj)


def _poll_result(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    if context.object is None or not result_objects.is_result(context.object):
        cls.poll_message_set(say("Select isolines first: an object that Make Isolines made"))
    elif context.mode != "OBJECT":
        cls.poll_message_set(say("Go to Object Mode first"))
    elif context.object.library or context.object.override_library:
        cls.poll_message_set(say("The isolines are linked from another file: make them and their data local first"))
    else:
        return True
    return False


def _poll_source(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    if not _poll_result(cls, context):
        return False
    if result_objects.find_source(context.object) is None:
        cls.poll_message_set(say("The mesh object of these isolines is gone: choose another as Source"))
        return False
    return True


def _activate(context: bpy.types.Context, obj: bpy.types.Object) -> None:
    """Selects the object alone, where this view layer has it."""
    for other in context.selected_objects:
        other.select_set(False)
    if obj.name in context.view_layer.objects:
        obj.select_set(True)
        context.view_layer.objects.active = obj


CLASSES = (DIRICHLET_OT_result_refresh, DIRICHLET_OT_result_remove, DIRICHLET_OT_result_select_source)
