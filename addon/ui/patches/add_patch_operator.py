# SPDX-License-Identifier: GPL-3.0-or-later
"""Adding a disc patch: by a press and a drag on the surface, or from a script."""

import bpy
from bpy.props import FloatProperty, FloatVectorProperty, IntProperty

from ...language import counted, label, say
from ..common import length, poll_mesh, reporting
from ..computing import Computing
from ..drawing.pointer import Pointer
from . import outline

_STILL = 4  # pixels that a hand moves without meaning to drag


class DIRICHLET_OT_add_patch_disc(Computing, bpy.types.Operator):
    bl_idname = "dirichlet.add_patch_disc"
    bl_label = "Add Patch"
    bl_description = (
        "Press on the surface to add a disc of vertices as a new vertex group and patch, with the next value; drag to "
        "set its radius along the surface. Esc or the right button leaves everything as it was"
    )
    bl_options = {"REGISTER", "UNDO", "BLOCKING"}

    location: FloatVectorProperty(
        name="Location",
        description="Middle of the disc, in object space; the nearest point of the mesh is taken",
        subtype="XYZ",
    )
    radius: FloatProperty(
        name="Radius",
        description="Radius along the surface, before the object is scaled; 0: the one used last on this object",
        subtype="DISTANCE",
        min=0.0,
        precision=4,
    )
    face: IntProperty(
        name="Face",
        description="Polygon with the middle, where known; -1: the nearest",
        default=-1,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    _disc = None  # until the library knows the mesh

    def begin(self, objects):
        from ...blender.paint import discs

        return discs.open_disc(objects[0], self._hit.location, objects[0].dirichlet.disc_radius, self._hit.face)

    def finish(self, context, made):
        self._disc, self._outline = made, outline.Outline(context.active_object)
        self._show()
        self._drag(context)  # the hand has not waited
        return self._add(context) if self._released else {"RUNNING_MODAL"}

    def execute(self, context):
        from ...blender.paint import discs

        obj = context.active_object
        with reporting(self):
            self.radius = self.radius or obj.dirichlet.disc_radius
            count = discs.add_disc(obj, self.location, self.radius, self.face if self.face >= 0 else None)
            vertices = counted(count, "1 vertex", "{count:,} vertices")
            radius = length(context, self.radius)
            self.report({"INFO"}, say("A patch of {vertices}, radius {radius}", vertices=vertices, radius=radius))
            return {"FINISHED"}
        return {"CANCELLED"}

    def invoke(self, context, event):
        if context.region is None or context.region.type != "WINDOW":
            self.report({"ERROR"}, "Press on the surface in a 3D viewport, or give the location")
            return {"CANCELLED"}
        self._pointer = Pointer(context.area, context.region, event)
        self._pressed, self._dragged, self._released = self._pointer.place, False, False
        self._hit = self._pointer.hit(context)
        if self._hit is None:
            name = context.active_object.name
            self.report({"ERROR"}, say("There is nothing of '{object}' under the pointer", object=name))
            return {"CANCELLED"}
        status = self.start(context, self.choose(context))
        if self._disc and status == {"CANCELLED"}:  # it could not be shown
            self._end()
        elif self._disc:
            context.window_manager.modal_handler_add(self)
        return status

    def modal(self, context, event):
        if event.type in {"ESC", "RIGHTMOUSE"}:
            self.cancel(context)
            return {"CANCELLED"}
        with reporting(self):
            self._pointer.move(event)
            self._released |= event.type == "LEFTMOUSE" and event.value == "RELEASE"
            if self._background:
                return (self.look(context) if event.type == "TIMER" else None) or {"RUNNING_MODAL"}
            if self._released or event.type == "MOUSEMOVE":  # of a quick hand the last moves are never told
                self._drag(context)
            return self._add(context) if self._released else {"RUNNING_MODAL"}
        self.cancel(context)
        return {"CANCELLED"}

    def cancel(self, context):
        if self._background:
            super().cancel(context)
        else:
            self._end()

    def _add(self, context):
        self._end()
        self.location, self.radius = self._hit.location, self._disc.radius
        self.face = -1 if self._hit.face is None else self._hit.face
        return self.execute(context)

    def _drag(self, context) -> None:
        self._dragged = self._dragged or (self._pointer.place - self._pressed).length > _STILL
        if self._dragged:
            world = self._pointer.at_depth_of(self._hit.shown) - self._hit.shown
            across = context.active_object.matrix_world.inverted_safe().to_3x3() @ world
            self._disc.resize(across.length)
            self._show()

    def _show(self) -> None:
        self._outline.set(*self._disc.outline())
        self._pointer.area.header_text_set(
            label(
                "Patch of {vertices}, radius {radius}   Drag: radius   Release: add   Esc, right button: no",
                vertices=counted(len(self._disc.vertices), "1 vertex", "{count:,} vertices"),
                radius=length(bpy.context, self._disc.radius),
            )
        )
        self._pointer.area.tag_redraw()

    def _end(self) -> None:
        self._outline.remove()
        self._pointer.area.header_text_set(None)
        self._pointer.area.tag_redraw()


CLASSES = (DIRICHLET_OT_add_patch_disc,)
