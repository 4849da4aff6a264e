# SPDX-License-Identifier: GPL-3.0-or-later
"""Picking from the surface."""

import bpy
from bpy.props import FloatVectorProperty

from ...language import label, say
from ..common import enum_name, poll_field, poll_mesh
from ..computing import Computing
from ..drawing import pointer

_VIEW = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "TRACKPADPAN", "TRACKPADZOOM"}  # may go on meanwhile


class DIRICHLET_OT_pick_level(Computing, bpy.types.Operator):
    bl_idname = "dirichlet.pick_level"
    bl_label = "Pick Level"
    bl_description = (
        "Click on the surface for the isoline through that point: its value joins the levels. Those of another mode "
        "become a list"
    )
    bl_options = {"REGISTER", "UNDO"}

    location: FloatVectorProperty(
        name="Location",
        description="Point that the isoline runs through, in object space; the nearest point of the mesh is taken",
        subtype="XYZ",
    )

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context) and poll_field(cls, context)

    def begin(self, objects):
        from ...blender.lines import level_picking

        settings = objects[0].dirichlet
        self._mode = label(enum_name(settings, "levels_mode"))
        self._listed = settings.levels_mode == "LIST"
        return level_picking.add_level(objects[0], self.location)

    def finish(self, context, made):
        (level,) = made.results
        if self._listed:
            text = say("Level {level:.7g} added to the list", level=level)
        else:
            text = say("Level {level:.7g} added; those of {mode} are listed now", level=level, mode=self._mode)
        self.report({"INFO"}, text)
        return {"FINISHED"}

    def invoke(self, context, event):
        context.window.cursor_modal_set("EYEDROPPER")
        context.workspace.status_text_set(label("Click: isoline through that point   Esc, right button: cancel"))
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if self._background:
            return super().modal(context, event)
        if event.type in {"ESC", "RIGHTMOUSE"}:
            self._end(context)
            return {"CANCELLED"}
        if event.type != "LEFTMOUSE" or event.value != "PRESS":
            return {"RUNNING_MODAL" if event.value == "PRESS" and event.type not in _VIEW else "PASS_THROUGH"}
        self._end(context)
        place = pointer.find(context, event)
        hit = place.hit(context) if place else None
        if hit is None:
            self.report(
                {"ERROR"}, say("There is nothing of '{object}' under the pointer", object=context.active_object.name)
            )
            return {"CANCELLED"}
        self.location = hit.location
        return self.work_on(context, self.choose(context))

    def cancel(self, context):
        if self._background:
            super().cancel(context)
        else:
            self._end(context)

    def _end(self, context) -> None:
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)


CLASSES = (DIRICHLET_OT_pick_level,)
