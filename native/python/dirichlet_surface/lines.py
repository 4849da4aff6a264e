# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines of a field, and ways to choose their levels."""

import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, Reals, as_count, as_reals, require_shape
from .mesh import Mesh, require_mesh


@dataclass(frozen=True)
class Isolines:
    """L polylines in one set of arrays: line l is points[offsets[l]:offsets[l + 1]]."""

    points: Reals
    """(P, 3) on the surface, in the unit of the positions"""
    edges: Indices
    """(P, 2) the mesh edge or polygon diagonal of every point, smaller vertex first; (0, 2) of resampled lines"""
    t: Reals
    """(P,) in [0, 1], from the first vertex of the edge to the second; (0,) of resampled lines"""
    offsets: Indices
    """(L + 1,)"""
    closed: NDArray[np.bool_]
    """(L,) whether the last point joins the first (which is not repeated)"""
    level: Indices
    """(L,) index into levels, ascending"""
    length: Reals
    """(L,) arc length, the closing segment included"""
    levels: Reals
    """(K,) as asked for"""
    seconds: float
    """wall time of the extraction"""
    warnings: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.length)

    def line(self, number: int) -> Reals:
        """The points (p, 3) of one line."""
        return self.points[self.offsets[number] : self.offsets[number + 1]]


def isolines(mesh: Mesh, values: ArrayLike, levels: ArrayLike) -> Isolines:
    """Where a field (V,) takes the given levels (K,), as connected polylines, higher values on their left.

    A vertex is above a level when its value is not smaller, with no tolerance: every line is closed, or ends on a
    border or at an edge of three or more faces; a plateau at the level lies above, the line runs along its rim.
    Triangles with a NaN carry no line. Of equal levels the first carries the lines; polygons are triangulated.

    Raises InputError (lengths, a level that is not finite, an infinite value) or TopologyError (a polygon that has no
    triangulation). Cost: O(V log K + F + output). Releases the GIL.
    """
    require_mesh(mesh)
    field = as_reals(values, "field values")
    require_shape(field, (mesh.vertex_count,), "field values")
    cuts = as_reals(levels, "levels")
    require_shape(cuts, (None,), "levels")
    start = time.perf_counter()
    arrays = _native.extract_isolines(mesh, field, cuts)
    seconds = time.perf_counter() - start
    return Isolines(**arrays, levels=cuts, seconds=seconds, warnings=_level_warnings(field, cuts))


def _level_warnings(field: Reals, levels: Reals) -> tuple[str, ...]:
    warnings = []
    repeated = len(levels) - len(np.unique(levels))
    if repeated:
        warnings.append(f"{repeated} of {len(levels)} levels repeat another and are counted once")
    low, high = np.fmin.reduce(field), np.fmax.reduce(field)  # of what is not NaN, without a copy
    if low <= high:
        outside = np.count_nonzero((levels < low) | (levels > high))
        if outside:
            warnings.append(f"{outside} of {len(levels)} levels lie outside the field's range {low:.6g} to {high:.6g}")
    return tuple(warnings)


def even_levels(low: float, high: float, count: int) -> Reals:
    """`count` levels spread evenly inside the window: low + (k + ½)(high − low)/count; none at its ends."""
    return _native.even_levels(low, high, as_count(count, "the number of levels", 1_000_000))


def stepped_levels(low: float, high: float, step: float, phase: float = 0.0) -> Reals:
    """The levels (k + phase) · step strictly inside (low, high); a phase from 0 to 1 moves the lines by one step."""
    return _native.stepped_levels(low, high, step, phase)


def level_through_point(mesh: Mesh, values: ArrayLike, point: ArrayLike) -> float:
    """The field's value at the point of the surface nearest to `point` (3,): the level whose line runs through it."""
    require_mesh(mesh)
    field = as_reals(values, "field values")
    require_shape(field, (mesh.vertex_count,), "field values")
    place = as_reals(point, "points")
    require_shape(place, (3,), "points")
    return _native.level_through_point(mesh, field, place.tolist())
