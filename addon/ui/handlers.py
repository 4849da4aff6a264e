# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender tells us of changes."""

import sys
from collections.abc import Iterable
from types import ModuleType

import bpy
from bpy.app.handlers import persistent

from ..blender.look import material


@persistent
def _depsgraph_updated(scene, depsgraph) -> None:
    """Painting and editing change the mesh; deforming it, or a setting of the object, the object alone, whose field
    need not depend on its shape."""
    blocks = [update.id.original for update in depsgraph.updates if update.is_updated_geometry]
    painted = [block for block in blocks if isinstance(block, bpy.types.Mesh)]
    for obj in (block for block in blocks if isinstance(block, bpy.types.Object)):
        _note([obj], lines=obj.data not in painted and not _is_solved_as_shown(obj.dirichlet), brush=True)
    for update in depsgraph.updates:
        if isinstance(update.id, bpy.types.Material):
            _note(material.shown_on(update.id.original, scene), colors=True)
    live = _used()
    if live and not live.is_busy():
        live.catch_up(depsgraph)


@persistent
def _undone(scene, depsgraph=None) -> None:
    """What was written outside of undo steps may be older or newer now than what it follows."""
    _note(bpy.data.objects)
    _note((obj for obj in bpy.data.objects if material.find(obj)), colors=True)


def _enabled() -> None:
    """Disabled, the add-on saw nothing of what changed, and forgot what it showed."""
    _note(bpy.data.objects)


@persistent
def _loaded(path) -> None:
    live = _used()
    if live:
        live.forget()
    _note(bpy.data.objects, lines=True)


@persistent
def _frame_changed(scene, depsgraph) -> None:
    if depsgraph.mode == "RENDER":
        from ..blender.mesh import evaluated

        for obj in scene.objects:
            evaluated.take_values(obj, depsgraph)
    changed = {update.id.original for update in depsgraph.updates if update.is_updated_geometry}
    _note(obj for obj in scene.objects if obj.animation_data or obj in changed or obj.data in changed)
    live = _used()
    if live:
        live.flush(depsgraph)


def _note(objects: Iterable[bpy.types.Object], *, colors=False, lines=False, brush=False) -> None:
    """Notes a change of each, of what all depends on unless something is named."""
    for obj in objects:
        if obj.type == "MESH" and (colors or _is_followed(obj.dirichlet)):
            from ..blender import live

            if live.is_busy():
                return
            what = live.Change.LINES
            what |= live.Change.COLORS if colors else live.Change(0) if lines else live.Change.FIELD
            live.changed(obj, what, brush=brush)


def _is_followed(settings: bpy.types.PropertyGroup) -> bool:
    return settings.live or settings.preview or settings.followed


def _is_solved_as_shown(settings: bpy.types.PropertyGroup) -> bool:
    return settings.use_modifiers and settings.laplacian != "graph"


def _used() -> ModuleType | None:
    """The module that follows, if anything was followed so far: it brings NumPy, which others need not wait for."""
    return sys.modules.get(f"{__package__.rpartition('.')[0]}.blender.live")


_HANDLERS = {
    "depsgraph_update_post": _depsgraph_updated,
    "undo_post": _undone,
    "redo_post": _undone,
    "load_post": _loaded,
    "frame_change_post": _frame_changed,
}


def register() -> None:
    for event, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, event).append(handler)
    bpy.app.timers.register(_enabled, first_interval=0)  # there are no objects to see while an add-on is enabled


def unregister() -> None:
    if bpy.app.timers.is_registered(_enabled):
        bpy.app.timers.unregister(_enabled)
    for event, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, event).remove(handler)
    live = _used()
    if live:
        live.stop()
