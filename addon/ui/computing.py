# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that may take long: they show how far they are, and can be cancelled."""

from time import perf_counter

import bpy
from bpy.props import BoolProperty, IntProperty, StringProperty

from .. import library
from ..blender import preferences
from ..language import label
from .common import report_made

_SLOW = 50_000  # vertices from which an operator may take half a second
_TICK = 0.1  # seconds between looks at the other thread
_LOOKING_AROUND = ("MIDDLEMOUSE", "WHEEL", "MOUSEMOVE", "TRACKPAD", "NDOF", "WINDOW", "TIMER")  # how events begin


class Computing:
    """Makes something of the chosen meshes: at once when executed; when invoked, large meshes are worked on beside the
    interface, and very large ones only when that has been agreed to."""

    confirmed: BoolProperty(
        name="Confirmed", description="Very large meshes have been agreed to", options={"HIDDEN", "SKIP_SAVE"}
    )
    _background = None

    def choose(self, context):
        """The mesh objects to work on."""
        raise NotImplementedError

    def begin(self, objects):
        """The work, as blender.work has it; it returns blender.several.Made."""
        raise NotImplementedError

    def expected_bytes(self, objects) -> float:
        raise NotImplementedError

    def is_slow(self, objects) -> bool:
        """Whether they take long though they are small."""
        return False

    def finish(self, context, made):
        return report_made(self, made)

    def execute(self, context):
        from ..blender import work

        manager = context.window_manager
        manager.progress_begin(0, 1)
        try:
            made = work.run(self.begin(self.choose(context)), manager.progress_update)
        except library.refusals() as error:
            return self._refuse(error)
        finally:
            manager.progress_end()
        return self.finish(context, made)

    def invoke(self, context, event):
        objects = self.choose(context)
        vertices = sum(len(mesh.vertices) for mesh in {obj.data for obj in objects})
        if bpy.app.background or not (vertices >= _SLOW or self.is_slow(objects)):
            return self.execute(context)
        if vertices >= preferences.get().ask_vertices and not self.confirmed:
            memory = round(self.expected_bytes(objects) / 1e6)
            bpy.ops.dirichlet.ask_first(
                "INVOKE_DEFAULT", asking=type(self).bl_idname.partition(".")[2], vertices=vertices, memory=memory
            )
            return {"CANCELLED"}
        return self._start(context, objects)

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, "Cancelled, nothing was changed")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type.startswith(_LOOKING_AROUND) else {"RUNNING_MODAL"}
        going = False
        try:
            made = self._background.poll()
            going = made is None
        except library.refusals() as error:
            return self._refuse(error)
        finally:
            if not going:
                self.cancel(context)
        if going:
            self._show_progress(context)
            return {"PASS_THROUGH"}
        return self.finish(context, made)

    def cancel(self, context):
        """Ends the work beside the interface; Blender calls it too, when it closes the file."""
        self._background.stop()
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        if context.workspace:
            context.workspace.status_text_set(None)

    def _start(self, context, objects):
        from ..blender import work

        try:
            self._background = work.Background(self.begin(objects))
        except library.refusals() as error:
            return self._refuse(error)
        manager = context.window_manager
        manager.progress_begin(0, 1)
        self._timer = manager.event_timer_add(_TICK, window=context.window)
        self._begun = perf_counter()
        manager.modal_handler_add(self)
        self._show_progress(context)
        return {"RUNNING_MODAL"}

    def _show_progress(self, context):
        step, seconds = self._background.step, perf_counter() - self._begun
        context.window_manager.progress_update(step.part)
        what = bpy.app.translations.pgettext_iface(self.bl_label, "Operator")
        text = label("{what}: {name}, {seconds:.0f} s     Esc: Cancel", what=what, name=step.name, seconds=seconds)
        context.workspace.status_text_set(text)

    def _refuse(self, error):
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}


class DIRICHLET_OT_ask_first(bpy.types.Operator):
    bl_idname = "dirichlet.ask_first"
    bl_label = "Very Large Mesh"
    bl_description = "Ask before an operator works on very many vertices; the preferences say from how many"
    bl_options = {"INTERNAL"}

    asking: StringProperty(name="Operator", description="The operator that asks", options={"SKIP_SAVE"})
    vertices: IntProperty(name="Vertices", description="How many it would work on", options={"SKIP_SAVE"})
    memory: IntProperty(name="Memory", description="Megabytes that it is expected to need", options={"SKIP_SAVE"})

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self, width=360)

    def draw(self, context):
        column = self.layout.column(align=True)
        column.label(text=label("{vertices:,} vertices", vertices=self.vertices), icon="MESH_DATA")
        column.label(
            text=label("About {gigabytes:.1f} GB of memory will be needed", gigabytes=self.memory / 1000), icon="MEMORY"
        )
        column.label(text="Esc cancels while it computes", icon="EVENT_ESC")

    def execute(self, context):
        getattr(bpy.ops.dirichlet, self.asking)("INVOKE_DEFAULT", confirmed=True)
        return {"FINISHED"}


CLASSES = (DIRICHLET_OT_ask_first,)
