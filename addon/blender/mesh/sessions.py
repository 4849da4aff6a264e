# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's mesh and solver of the Blender meshes in use, so that a stroke costs no more than what it changed.

A session holds as long as the mesh's faces are exactly those it was made of; its solver too, and where the Laplacian
sees positions, as long as those are the same. It is found by the mesh's address, which
survives renaming; whether it fits is decided by the arrays alone, so nothing has to tell it of edits, undo or loading.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Generator
from functools import partial
from threading import Lock
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say
from .. import expected_memory, preferences
from ..held import Held
from ..work import Step, run
from . import meshes

_MOST = 4  # sessions kept; the one used longest ago goes first
_sessions: OrderedDict[int, Session] = OrderedDict()


class Session:
    """A mesh data-block as the library has it."""

    def __init__(self, arrays: meshes.Arrays, mesh: Any) -> None:
        """mesh: the library's, of these arrays."""
        self.arrays, self.mesh = arrays, mesh
        self.solver_bytes = 0  # that the solver takes
        self._lock = Lock()  # held by who paints
        self._turn = Lock()  # held for a moment, by who looks or changes whose painting is worked on
        self._token: Any = library.load().CancelToken()  # the solver's
        self._current: Any = None  # the token of the painting that is worked on
        self._stopped = False
        self._deformed: Any = None
        self._solver: Any = None
        self._made_of: tuple[dict[str, Any], Any] | None = None  # the solver: options, and the mesh where it counts

    def deformed(self, positions: NDArray[np.float64]) -> Any:
        """The library's Mesh with the vertices elsewhere (V, 3), the same one for the same positions."""
        if self._deformed is None or not np.array_equal(self._deformed.positions, positions):
            self._deformed = self.mesh.moved(positions)
        return self._deformed

    def paint(
        self, painting: Any, options: dict[str, Any], surface: Any = None, stop: Any = None
    ) -> tuple[NDArray[np.float64], Any]:
        """Values (V,) and report of the library's HarmonicSolver with these options, which is kept for the next
        painting. surface: the library's Mesh of these faces to solve on, this session's if nothing is said. Raises
        what HarmonicSolver and its `paint` raise. For any thread; one call waits for the other.

        stop: a CancelToken by which `interrupt` ends this painting alone.
        """
        with self._lock:
            self._begin(stop)
            try:
                return self._paint(painting, options, surface or self.mesh)
            finally:
                with self._turn:
                    self._current = None

    def interrupt(self, stop: Any) -> None:
        """Ends the painting that was given this token by CancelledError, whether a thread is at it or it waits for
        others, which go on. The next painting is whole again."""
        with self._turn:
            stop.cancel()
            if self._current is stop:
                self._token.cancel()

    def stop(self) -> None:
        """Ends what a thread is painting, and all painting to come."""
        with self._turn:
            self._stopped = True
            self._token.cancel()

    def is_busy(self) -> bool:
        return self._lock.locked()

    def forget_solver(self) -> bool:
        """Frees the largest thing there is, whoever still holds the session; False while somebody paints."""
        if not self._lock.acquire(blocking=False):
            return False
        try:
            self._drop_solver()
        finally:
            self._lock.release()
        return True

    def _drop_solver(self) -> None:
        self._solver = self._made_of = None
        self.solver_bytes = 0

    @property
    def bytes(self) -> float:
        """That it takes, about, by what the library tells of its factor."""
        meshes_kept = 1 if self._deformed is None else 2
        return meshes_kept * expected_memory.of_lines(len(self.arrays.positions)) + self.solver_bytes

    def _begin(self, stop: Any) -> None:
        with self._turn:
            self._current = stop
            if self._stopped or (stop and stop.is_cancelled):
                self._token.cancel()
            else:
                self._token.reset()

    def _paint(self, painting: Any, options: dict[str, Any], surface: Any) -> tuple[NDArray[np.float64], Any]:
        made_of = options, None if sees_no_positions(options) else surface
        if self._made_of != made_of:
            self._drop_solver()  # first: a factor is the largest thing there is
            self._solver = library.load().HarmonicSolver(surface, **options, cancel=self._token)
            self._made_of = made_of
        values = self._solver.paint(painting.vertices, painting.values)
        report = self._solver.report
        self.solver_bytes = expected_memory.of_solver(report.vertices, report.factor_nonzeros)
        return values, report


def sees_no_positions(options: dict[str, Any]) -> bool:
    """Whether the Laplacian knows the vertices by their neighbours alone."""
    return options.get("laplacian", "graph") == "graph"


def open_session(obj: bpy.types.Object) -> Session:
    """The session of the object's mesh as it is now; those of meshes that are gone end here. Raises what
    meshes.read_arrays and the library's Mesh raise."""
    return run(opening(Held(obj)))


def opening(held: Held, part: float = 0.0) -> Generator[Step, Any, Session]:
    """The same as a part of a work, a step of its own where the library's mesh is still to be made. What is held is
    then kept to these arrays."""
    _forget_removed()
    obj = held.find_mesh()
    arrays = meshes.read_arrays(obj.data)
    held.keep(arrays)
    session = _sessions.get(obj.data.as_pointer())
    if session and session.arrays.same(arrays):
        return _put(obj, session)
    preferences.limit_threads()
    known = session.mesh if session and session.arrays.same_faces(arrays) else None
    mesh = yield Step(held.name, part, partial(meshes.build, arrays, known), say("connecting the mesh"))
    obj = held.find_mesh()
    session = _sessions.get(obj.data.as_pointer())
    if session and session.arrays.same_faces(arrays):  # what knows of positions looks at the mesh
        session.arrays, session.mesh = arrays, mesh
        return _put(obj, session)
    if session:
        session.stop()
    return _put(obj, Session(arrays, mesh))


def make_room(session: Session, expected: float = 0.0) -> None:
    """Forgets the sessions used longest ago, of those that are not busy, until the others and this one, once it takes
    the bytes expected of it, keep to the memory budget."""
    room = preferences.memory_budget() or library.load().default_memory_budget()
    others = {key: one for key, one in _sessions.items() if one is not session}
    for key, one in list(others.items()):
        if len(others) < _MOST and sum(o.bytes for o in others.values()) + max(session.bytes, expected) <= room:
            break
        if one.forget_solver():
            del _sessions[key], others[key]  # not stopped: what it is about to compute may still be waited for


def _put(obj: bpy.types.Object, session: Session) -> Session:
    """Keeps it, as the newest."""
    key = obj.data.as_pointer()
    _sessions[key] = session
    _sessions.move_to_end(key)
    make_room(session)
    return session


def forget_all() -> None:
    """Of a file that is closed: what they compute is for nobody, and stops."""
    for session in _sessions.values():
        session.stop()
    _sessions.clear()


def _forget_removed() -> None:
    present = {mesh.as_pointer() for mesh in bpy.data.meshes}
    for key in [key for key in _sessions if key not in present]:
        _sessions.pop(key).stop()
