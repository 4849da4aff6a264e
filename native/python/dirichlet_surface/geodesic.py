# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances along a surface."""

from __future__ import annotations

import operator

from numpy.typing import ArrayLike

from . import _native
from ._arrays import Indices, Reals, as_real, as_reals, require_shape
from ._native import InputError
from .cancel import CancelToken, as_token
from .mesh import Mesh, require_mesh


def geodesic_disc(
    mesh: Mesh, point: ArrayLike, radius: float, face: int | None = None, *, cancel: CancelToken | None = None
) -> tuple[Indices, Reals]:
    """The vertices (C,), ascending, whose distance along the surface from a point is at most `radius`; and theirs (C,).

    point   (3,) the disc's middle is the surface's nearest point to it
    radius  >= 0, or infinite. Smaller than the way to the nearest vertex it gives an empty disc; 0 gives the vertex
            that the point is, if it is one.
    face    the polygon that the middle lies on, which spares the search for it
    cancel  stops the front from another thread: CancelledError

    Straight where the surface is flat around the point (to rounding, for Delaunay triangles) and along chains of
    edges; first order in the size of the triangles elsewhere; never below the straight distance in space. A larger
    radius holds every vertex that a smaller one does, and a disc never leaves its piece of the surface.

    Raises InputError (a number that is not finite, a radius below 0, no such face) or TopologyError (a polygon that has
    no triangulation). Cost: O(C log C), the first call for a mesh O(V + F); without `face` O(F). Releases the GIL.
    """
    require_mesh(mesh)
    place = as_reals(point, "points")
    require_shape(place, (3,), "points")
    token = as_token(cancel)
    return _native.geodesic_disc(mesh, place.tolist(), as_real(radius, "radii"), _face(mesh, face), token)


def _face(mesh: Mesh, face: int | None) -> int | None:
    if face is None:
        return None
    try:
        number = operator.index(face)
    except TypeError:
        raise InputError(f"the face has to be a whole number, not {face!r}") from None
    if not 0 <= number < mesh.face_count:
        raise InputError(f"there is no face {number}: the faces are 0 to {mesh.face_count - 1}")
    return number
