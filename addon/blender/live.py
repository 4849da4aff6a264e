# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields, colours and lines that follow what they depend on.

`changed` notes that something did, and returns at once. The work is done when the brush rests: while Blender evaluates
the change, so that one redraw shows both; for large meshes in a thread, whose result a timer fetches if it is late. The
newest change wins: what was computed for an older one is dropped. Between two calls nothing is kept of Blender's data
but addresses, looked up before use, so undo, loading, renaming and deleting do no harm.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter

import bpy

from ..language import say
from . import preferences, threads
from .follower import Change, Follower, Preview
from .mesh import sessions

_INLINE = 50_000  # vertices up to which a field takes less than handing it to a thread
_SLOW_LINES = 0.1  # seconds that lines may take at every change before a thread computes them
_PATIENCE = 0.3  # seconds that Blender waits for a thread before it draws without what comes of it
_STOPPING = 5.0  # seconds that a thread has to stop
_POLL = 0.005  # seconds between looks at a brush or a thread that is busy

_followers: dict[int, Follower] = {}  # by the address of the object
_busy = False
_operator: tuple[int, int] = (0, 0)  # the last one that had finished at the last look


def changed(obj: bpy.types.Object, what: Change, *, brush: bool = False) -> None:
    """Notes that `what` of the object is to be done anew, as far as it follows. With `brush` a stroke may be going on,
    whose end is waited for, unless its field is to be solved already: a setting looks like a stroke once evaluated."""
    what &= _followed(obj)
    if not what:
        return
    follower = _followers.setdefault(obj.as_pointer(), Follower(obj))
    told = Change.FIELD in follower.due() and len(obj.data.vertices) <= _INLINE
    follower.note(what, resting=told or not (brush and _brush_may_move()))
    if not bpy.app.background and not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=0, persistent=True)


def catch_up(depsgraph: bpy.types.Depsgraph) -> None:
    """Does what is due, or begins on it, in a handler after which Blender evaluates by itself."""
    global _operator
    for follower in list(_followers.values()):
        obj = follower.held.now() if follower.postponed or follower.has_something_to_do() else None
        if obj and _is_in(obj, depsgraph):
            follower.resume(obj)
            if follower.has_something_to_do():
                with _own_changes(evaluate=False):
                    _advance(follower, obj, thread=_needs_thread(obj, follower), depsgraph=depsgraph)
    _operator = _last_operator()


def flush(depsgraph: bpy.types.Depsgraph | None = None) -> None:
    """Does all that is pending, now: for scripts, tests and frame changes, which bring their depsgraph."""
    for follower in list(_followers.values()):
        obj = follower.held.now()
        if obj and (depsgraph is None or _is_in(obj, depsgraph)):
            with _own_changes(evaluate=depsgraph is None):
                follower.resting = True
                while follower.pending or follower.job:
                    _finish(follower, obj)
                    follower.begin(obj, thread=False, depsgraph=depsgraph)


def preview_of(obj: bpy.types.Object) -> Preview | None:
    """The lines to draw for the object, if it has any."""
    follower = _followers.get(obj.as_pointer())
    return follower.preview if follower and obj.dirichlet.preview else None


def timings(obj: bpy.types.Object) -> dict[str, float]:
    """Seconds of the stages of the last update: those of its tasks, "wait" from the last change to its begin, "total"
    from there to its end."""
    follower = _followers.get(obj.as_pointer())
    return dict(follower.seconds) if follower else {}


def is_pending(obj: bpy.types.Object) -> bool:
    """Whether something is still to be done for the object, or is being computed."""
    follower = _followers.get(obj.as_pointer())
    return bool(follower and (follower.pending or follower.job))


def is_busy() -> bool:
    """Whether changes are our own, which nothing has to follow."""
    return _busy


def forget() -> None:
    """Of a file that is closed."""
    _followers.clear()
    sessions.forget_all()


def stop() -> None:
    """Follows nothing any more, and stops what is computed."""
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)
    forget()
    threads.settle(_STOPPING)


def _followed(obj: bpy.types.Object) -> Change:
    """What of the object follows by itself."""
    settings = obj.dirichlet
    if obj.type != "MESH" or any(block.library or block.override_library for block in (obj, obj.data)):
        return Change(0)
    if not obj.users_collection:  # deleted, and only remembered by its results
        return Change(0)
    what = Change.COLORS
    if settings.live:
        what |= Change.LINES | (Change.FIELD if _owner(obj) == obj else Change(0))
    if settings.preview or settings.followed:
        what |= Change.LINES
    return what


def _tick() -> float | None:
    """One look at everything; the seconds to the next one, or nothing when all is done."""
    global _operator
    stroke_ended = _stroke_ended()
    for address, follower in list(_followers.items()):
        obj = follower.held.now()
        if obj is None and not follower.is_computing():
            del _followers[address]
        elif obj:
            follower.resting |= stroke_ended or perf_counter() - follower.noted >= preferences.get().live_delay
            if follower.has_something_to_do():
                with _own_changes():
                    _advance(follower, obj, thread=_needs_thread(obj, follower))
    _operator = _last_operator()
    return _POLL if any(follower.pending or follower.job for follower in _followers.values()) else None


def _advance(
    follower: Follower,
    obj: bpy.types.Object,
    *,
    thread: bool,
    depsgraph: bpy.types.Depsgraph | None = None,
) -> None:
    """Writes what is computed, begins on what is due, and writes that too unless a thread takes long."""
    if not follower.is_computing():  # as it is where what was evaluated just before began on it
        _finish(follower, obj)
    follower.begin(obj, thread=thread, depsgraph=depsgraph)
    follower.wait(_PATIENCE)
    if not follower.is_computing():
        _finish(follower, obj)


def _finish(follower: Follower, obj: bpy.types.Object) -> None:
    owner = _owner(obj)
    shared = say("'{owner}' is live on the same mesh, by its own patches", owner=owner.name) if owner != obj else ""
    before = follower.preview
    follower.finish(obj, _followed(obj), shared)
    if follower.preview is not before:
        _redraw()


def _redraw() -> None:
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def _owner(obj: bpy.types.Object) -> bpy.types.Object:
    """Whose patches count on a mesh that several objects share: the active one's of those with Live on."""
    if not obj.dirichlet.live or obj.data.users == 1:
        return obj
    sharing = [other for other in bpy.data.objects if other.data == obj.data and other.dirichlet.live]
    active = bpy.context.view_layer.objects.active
    return active if active in sharing else sharing[0]


def _is_in(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> bool:
    """Whether it is this one that evaluates the object: others, of other scenes, know nothing of its shape."""
    return depsgraph.view_layer.objects.get(obj.name) == obj


def _needs_thread(obj: bpy.types.Object, follower: Follower) -> bool:
    """Without a window nobody waits for a redraw, and no timer runs."""
    field = Change.FIELD in follower.due() and len(obj.data.vertices) > _INLINE
    return not bpy.app.background and (field or follower.seconds.get("isolines", 0) > _SLOW_LINES)


def _brush_may_move() -> bool:
    return not bpy.app.background and not _stroke_ended()


def _stroke_ended() -> bool:
    """Whether an operator has finished since the last look: a brush does when it is lifted."""
    return _last_operator() != _operator


def _last_operator() -> tuple[int, int]:
    operators = bpy.context.window_manager.operators
    return (len(operators), operators[-1].as_pointer()) if operators else (0, 0)


@contextmanager
def _own_changes(evaluate: bool = True) -> Iterator[None]:
    """What is written here, Blender evaluates here too, so that nobody takes it for a change of the user's; what the
    user changed just before is evaluated first, and noted. A frame change evaluates all by itself."""
    global _busy
    _evaluate(evaluate)
    _busy = True
    try:
        yield
        _evaluate(evaluate)
    finally:
        _busy = False


def _evaluate(wanted: bool) -> None:
    if wanted:
        for window in bpy.context.window_manager.windows:
            window.view_layer.update()
