# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that may take long: they show how far they are, and can be cancelled."""

from time import perf_counter

import bpy
from bpy.props import BoolProperty, IntProperty, StringProperty

from ..blender import preferences
from ..language import label
from .common import report_made, reporting

_SLOW = 50_000  # vertices from which an operator may take half a second
_PATIENCE = 0.3  # seconds that Blender waits for what may be quick after all
_TICK = 0.1  # seconds between looks at the other thread
_LOOKING_AROUND = ("MIDDLEMOUSE", "WHEEL", "MOUSEMOVE", "TRACKPAD", "NDOF", "WINDOW", "TIMER")  # how events begin


class Computing:
    """Works on the chosen objects: at once when executed; when invoked, large meshes are worked on beside the
    interface, and very large ones only when that has been agreed to."""

    confirmed: BoolProperty(
        name="Confirmed", description="Very large meshes have been agreed to", options={"HIDDEN", "SKIP_SAVE"}
    )
    _background = None

    def choose(self, context):
        """The objects to work on."""
        return [context.active_object]

    def begin(self, objects):
        """The work, as blender.work has it; what it returns goes to `finish`."""
        raise NotImplementedError

    def sources(self, objects):
        """The mesh objects that these depend on."""
        return objects

    def expected_bytes(self, objects) -> float:
        """To be agreed to where the mesh is very large; 0: that is not asked."""
        return 0.0

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
            with reporting(self):
                return self.finish(context, work.run(self.begin(self.choose(context)), manager.progress_update))
        finally:
            manager.progress_end()
        return {"CANCELLED"}

    def invoke(self, context, event):
        return self.work_on(context, self.choose(context))

    def work_on(self, context, objects):
        """For `invoke`, and what people did in a window after it."""
        sources = self.sources(objects)
        vertices = sum(len(mesh.vertices) for mesh in {obj.data for obj in sources})
        if bpy.app.background or not (vertices >= _SLOW or self.is_slow(sources)):
            return self.execute(context)
        memory = 0 if self.confirmed else round(self.expected_bytes(sources) / 1e6)
        if vertices >= preferences.get().ask_vertices and memory:
            bpy.ops.dirichlet.ask_first(
                "INVOKE_DEFAULT", asking=type(self).bl_idname.partition(".")[2], vertices=vertices, memory=memory
            )
            return {"CANCELLED"}
        return self.start(context, objects)

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, "Cancelled, nothing was changed")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type.startswith(_LOOKING_AROUND) else {"RUNNING_MODAL"}
        return self.look(context) or {"PASS_THROUGH"}

    def cancel(self, context):
        """Ends the work beside the interface; Blender calls it too, when it closes the file."""
        background, self._background = self._background, None
        background.stop()
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        if context.workspace:
            context.workspace.status_text_set(None)

    def look(self, context):
        """What the operator returns now that its work has ended; nothing while it goes on."""
        made, going = None, False
        try:
            with reporting(self):
                made = self._background.poll()
                going = made is None
        finally:
            if not going:
                self.cancel(context)
        if going:
            self._show_progress(context)
            return None
        return {"CANCELLED"} if made is None else self.finish(context, made)

    def start(self, context, objects):
        """Works beside the interface, unless it is done before anybody notices."""
        from ..blender import work

        with reporting(self):
            background = work.Background(self.begin(objects))
            made = background.wait(_PATIENCE)
            if made is not None:
                return self.finish(context, made)
            self._watch(context, background)
            return {"RUNNING_MODAL"}
        return {"CANCELLED"}

    def _watch(self, context, background) -> None:
        manager = context.window_manager
        manager.progress_begin(0, 1)
        self._background, self._begun = background, perf_counter()
        self._timer = manager.event_timer_add(_TICK, window=context.window)
        manager.modal_handler_add(self)
        self._show_progress(context)

    def _show_progress(self, context):
        step, seconds = self._background.step, perf_counter() - self._begun
        context.window_manager.progress_update(step.part)
        what = bpy.app.translations.pgettext_iface(self.bl_label, "Operator")
        name = ", ".join(filter(None, (step.name, step.doing)))
        text = label("{what}: {name}, {seconds:.0f} s     Esc: Cancel", what=what, name=name, seconds=seconds)
        context.workspace.status_text_set(text)


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
        getattr(bpy.ops.dirichlet, self.asking)("INVOKE_DEFAULT", True, confirmed=True)  # True: with its undo step
        return {"FINISHED"}


CLASSES = (DIRICHLET_OT_ask_first,)
