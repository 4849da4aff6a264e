# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs on the surface, as patches."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say
from ..held import Held
from ..mesh import evaluated, sessions
from ..work import Step, Work, run, stopping
from . import patches

_MARGIN = 1.5  # of the radius: as far around are distances known, for the outline between the vertices
_WHITE = np.ones((1, 4), np.float32)


class Disc:
    """The vertices within a radius along the surface around a point, both in object space. Nothing is written."""

    def __init__(
        self, obj: bpy.types.Object, session: sessions.Session, location: Sequence[float], face: int | None
    ) -> None:
        self._mesh: Any = session.mesh
        deformed = obj.modifiers or obj.data.shape_keys
        self._shown = evaluated.read_positions(obj, session.arrays) if deformed else None
        self._location, self._face = location, face
        self.radius = 0.0
        self.vertices: NDArray[np.int32] = np.zeros(0, np.int32)

    def resize(self, radius: float, cancel: Any = None) -> None:
        """cancel: the library's CancelToken. Raises what its geodesic_disc raises."""
        reach = radius * _MARGIN
        self.radius = radius
        measure = library.load().geodesic_disc
        self._known, self._distances = measure(self._mesh, self._location, reach, self._face, cancel=cancel)
        self.vertices = self._known[self._distances <= radius]

    def outline(self) -> tuple[Any, NDArray[np.float32]]:
        """The library's Isolines of the distance at the radius, round holes too, and the colour (1, 4) to show them.

        They lie on the surface as it was shown at first, unless modifiers change its faces.
        """
        distances = np.full(self._mesh.vertex_count, self.radius * _MARGIN)
        distances[self._known] = self._distances
        lines = library.load().isolines(self._mesh, distances, [self.radius])
        return lines if self._shown is None else library.load().move_lines(lines, self._shown), _WHITE


def open_disc(obj: bpy.types.Object, location: Sequence[float], radius: float, face: int | None = None) -> Work:
    """A disc of that radius. Raises what open_session and Disc.resize raise."""
    held = Held(obj)
    session = yield from sessions.opening(held)
    disc, cancel = Disc(held.find_mesh(), session, location, face), library.load().CancelToken()
    with stopping(cancel.cancel):
        yield Step(held.name, 0.5, partial(disc.resize, radius, cancel))
    held.find_mesh()
    return disc


def add_disc(obj: bpy.types.Object, location: Sequence[float], radius: float, face: int | None = None) -> int:
    """Adds a patch of a disc in object space, remembers the radius and returns the number of vertices.

    Raises what `open_disc` raises, and InputError when no vertex is near enough.
    """
    disc = run(open_disc(obj, location, radius, face))
    if not disc.vertices.size:
        raise library.load().InputError(
            say(
                "no vertex of '{object}' is within {radius:.4g} of that point: take a larger radius or a finer mesh",
                object=obj.name,
                radius=radius,
            )
        )
    patches.add_group(obj, "Disc", disc.vertices)
    patches.recheck(obj)
    obj.dirichlet.disc_radius = radius
    return len(disc.vertices)
