# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines of a field, and ways to choose their levels."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, Reals, as_count, as_real, as_reals, require_shape
from ._text import and_more, counted, told_apart
from .cancel import CancelToken, as_token
from .mesh import Mesh, require_mesh

_MOST_LEVELS = 1_000_000


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


def isolines(mesh: Mesh, values: ArrayLike, levels: ArrayLike, *, cancel: CancelToken | None = None) -> Isolines:
    """Where a field (V,) takes the given levels (K,), as connected polylines, higher values on their left.

    A vertex is above a level when its value is not smaller, with no tolerance: every line is closed, or ends on a
    border or at an edge of three or more faces; a plateau at the level lies above, the line runs along its rim.
    Triangles with a NaN carry no line. Of equal levels the first carries the lines; polygons are triangulated. Another
    thread may stop it by `cancel`: CancelledError.

    Raises InputError (lengths, a level that is not finite, an infinite value) or TopologyError (a polygon that has no
    triangulation). Cost: O(V log K + F + output). Releases the GIL.
    """
    require_mesh(mesh)
    field = as_reals(values, "field values")
    require_shape(field, (mesh.vertex_count,), "field values")
    cuts = as_reals(levels, "levels")
    require_shape(cuts, (None,), "levels")
    start = time.perf_counter()
    arrays = _native.extract_isolines(mesh, field, cuts, as_token(cancel))
    seconds = time.perf_counter() - start
    return Isolines(**arrays, levels=cuts, seconds=seconds, warnings=_level_warnings(field, cuts, arrays["level"]))


def _level_warnings(field: Reals, levels: Reals, carried: Indices) -> tuple[str, ...]:
    """`carried`: (L,) the level of every line."""
    warnings = []
    distinct, places = np.unique(levels, return_index=True)
    repeated = len(levels) - len(distinct)
    if repeated:
        verb = "repeats another and counts" if repeated == 1 else "repeat another and count"
        warnings.append(f"{repeated} of {counted(len(levels), 'level')} {verb} once")
    low, high = np.fmin.reduce(field), np.fmax.reduce(field)  # of what is not NaN, without a copy
    if len(levels) and not low <= high:
        warnings.append("the field has no value at any vertex, so there are no lines")
    if low <= high:
        outside = (distinct < low) | (distinct > high)
        missed = ~outside & ~np.isin(places, carried)
        if outside.any():
            place, count = places[outside].min(), int(np.count_nonzero(outside))
            level, *ends = told_apart(levels[place], low, high)
            text = f"level {level} (at place {place}) lies outside the field's range {' to '.join(ends)}"
            warnings.append(text + and_more(count, "level"))
        if missed.any():
            place, count = places[missed].min(), int(np.count_nonzero(missed))
            text = f"level {levels[place]:.6g} (at place {place}) has no line, as the field does not cross it"
            warnings.append(text + and_more(count, "level"))
    return tuple(warnings)


def even_levels(low: float, high: float, count: int) -> Reals:
    """`count` levels spread evenly inside the window: low + (k + ½)(high − low)/count; none at its ends."""
    ends = as_real(low, "ends of the window"), as_real(high, "ends of the window")
    return _native.even_levels(*ends, as_count(count, "the number of levels", _MOST_LEVELS))


def stepped_levels(low: float, high: float, step: float, phase: float = 0.0) -> Reals:
    """The levels (k + phase) · step strictly inside (low, high); a phase from 0 to 1 moves the lines by one step."""
    ends = as_real(low, "ends of the window"), as_real(high, "ends of the window")
    return _native.stepped_levels(*ends, as_real(step, "steps"), as_real(phase, "phases"))


def equal_area_levels(
    mesh: Mesh,
    values: ArrayLike,
    count: int,
    low: float | None = None,
    high: float | None = None,
    *,
    cancel: CancelToken | None = None,
) -> Reals:
    """`count` levels, ascending, that cut the surface into `count` + 1 strips of equal areas.

    values     (V,); triangles on which the field is constant do not count, nor do those with a NaN
    low, high  the window that is cut; nothing said: the field's range
    cancel     stops it from another thread: CancelledError

    The areas are equal to 1e-9 of their sum, where there are enough doubles. Raises InputError (lengths, an infinite
    value, a field that is constant or has no values, a window that is empty or holds none of the surface) or
    TopologyError (a polygon that has no triangulation). Cost: O(V + F) about five times, and that of 1000 isolines.
    Releases the GIL.
    """
    return _spread(_native.equal_area_levels, mesh, values, count, low, high, cancel)


def equal_distance_levels(
    mesh: Mesh,
    values: ArrayLike,
    count: int,
    low: float | None = None,
    high: float | None = None,
    *,
    cancel: CancelToken | None = None,
) -> Reals:
    """`count` levels, ascending, from one of which to the next lines advance equally far on average.

    So they do from the ends of the window to the levels beside them. How far lines advance is the area they sweep,
    divided by their length, added up over a thousand or more small steps. Arguments, errors and cost as for
    equal_area_levels.
    """
    return _spread(_native.equal_distance_levels, mesh, values, count, low, high, cancel)


def _spread(
    spread: Callable[[Mesh, Reals, int, float | None, float | None, CancelToken], Reals],
    mesh: Mesh,
    values: ArrayLike,
    count: int,
    low: float | None,
    high: float | None,
    cancel: CancelToken | None,
) -> Reals:
    require_mesh(mesh)
    field = as_reals(values, "field values")
    require_shape(field, (mesh.vertex_count,), "field values")
    low, high = (None if end is None else as_real(end, "ends of the window") for end in (low, high))
    return spread(mesh, field, as_count(count, "the number of levels", _MOST_LEVELS), low, high, as_token(cancel))


def level_through_point(mesh: Mesh, values: ArrayLike, point: ArrayLike) -> float:
    """The field's value at the point of the surface nearest to `point` (3,): the level whose line runs through it."""
    require_mesh(mesh)
    field = as_reals(values, "field values")
    require_shape(field, (mesh.vertex_count,), "field values")
    place = as_reals(point, "points")
    require_shape(place, (3,), "points")
    return _native.level_through_point(mesh, field, place.tolist())
