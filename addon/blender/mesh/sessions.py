# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's mesh and solver of the Blender meshes in use, so that a stroke costs no more than what it changed.

A session holds as long as the mesh's faces are exactly those it was made of; its solver too, and where the Laplacian
sees positions, as long as those are the same. It is found by the mesh's address, which
survives renaming; whether it fits is decided by the arrays alone, so nothing has to tell it of edits, undo or loading.
"""

from __future__ import annotations

from collections import OrderedDict
from threading import Lock
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from .. import preferences
from . import meshes

_MOST = 4  # sessions kept; the one used longest ago goes first
_sessions: OrderedDict[int, Session] = OrderedDict()


class Session:
    """A mesh data-block as the library has it."""

    def __init__(self, arrays: meshes.Arrays) -> None:
        self.arrays = arrays
        self.mesh: Any = meshes.build(arrays)
        self._lock = Lock()
        self._token: Any = library.load().CancelToken()
        self._stopped = False
        self._deformed: Any = None
        self._solver: Any = None
        self._made_of: tuple[dict[str, Any], Any] | None = None  # the solver: options, and the mesh where it counts

    def deformed(self, positions: NDArray[np.float64]) -> Any:
        """The library's Mesh with the vertices elsewhere (V, 3), the same one for the same positions."""
        if self._deformed is None or not np.array_equal(self._deformed.positions, positions):
            self._deformed = library.load().Mesh(positions, (self.arrays.offsets, self.arrays.corners))
        return self._deformed

    def paint(self, painting: Any, options: dict[str, Any], surface: Any = None) -> tuple[NDArray[np.float64], Any]:
        """Values (V,) and report of the library's HarmonicSolver with these options, which is kept for the next
        painting. surface: the library's Mesh of these faces to solve on, this session's if nothing is said. Raises
        what HarmonicSolver and its `paint` raise. For any thread; one call waits for the other."""
        surface = surface or self.mesh
        made_of = options, None if sees_no_positions(options) else surface
        with self._lock:
            self._token.reset()
            if self._stopped:
                self._token.cancel()
            if self._made_of != made_of:
                self._solver = self._made_of = None  # first: a factor is the largest thing there is
                self._solver = library.load().HarmonicSolver(surface, **options, cancel=self._token)
                self._made_of = made_of
            values = self._solver.paint(painting.vertices, painting.values)
            return values, self._solver.report

    def interrupt(self) -> None:
        """Ends what a thread is painting by CancelledError; the next painting is whole again."""
        self._token.cancel()

    def stop(self) -> None:
        """Ends what a thread is painting, and all painting to come."""
        self._stopped = True
        self._token.cancel()

    def follow(self, arrays: meshes.Arrays) -> bool:
        """Whether these are its faces; then it takes the positions."""
        if not self.arrays.same_faces(arrays):
            return False
        if not np.array_equal(self.arrays.positions, arrays.positions):
            self.mesh = meshes.build(arrays)
        self.arrays = arrays
        return True


def sees_no_positions(options: dict[str, Any]) -> bool:
    """Whether the Laplacian knows the vertices by their neighbours alone."""
    return options.get("laplacian", "graph") == "graph"


def open_session(obj: bpy.types.Object) -> Session:
    """The session of the object's mesh as it is now; those of meshes that are gone end here. Raises what
    meshes.read_arrays and the library's Mesh raise."""
    _forget_removed()
    key = obj.data.as_pointer()
    arrays = meshes.read_arrays(obj.data)
    session = _sessions.pop(key, None)
    if session and not session.follow(arrays):
        session.stop()
        session = None
    if session is None:
        preferences.limit_threads()
        session = Session(arrays)
    _sessions[key] = session
    if len(_sessions) > _MOST:
        _sessions.popitem(last=False)  # not stopped: what it computes may still be waited for
    return session


def abandon(session: Session) -> None:
    """Nobody waits any more for what its solver is busy with: it stops, and the next to open one gets another."""
    session.stop()
    for key in [key for key, one in _sessions.items() if one is session]:
        del _sessions[key]


def forget_all() -> None:
    """Of a file that is closed: what they compute is for nobody, and stops."""
    for session in _sessions.values():
        session.stop()
    _sessions.clear()


def _forget_removed() -> None:
    present = {mesh.as_pointer() for mesh in bpy.data.meshes}
    for key in [key for key in _sessions if key not in present]:
        _sessions.pop(key).stop()
