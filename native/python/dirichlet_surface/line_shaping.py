# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be done to isolines once they are there.

Every function gives new lines: their order, levels and closedness stay, their lengths are measured anew. All raise
InputError for numbers out of range and for lines whose arrays do not fit together, and release the GIL. What can take
long takes a CancelToken `cancel` by which another thread may stop it: CancelledError.
"""

from __future__ import annotations

import operator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._arrays import as_indices, as_real, as_reals, require_shape
from ._native import InputError
from .cancel import CancelToken, as_token
from .lines import Isolines
from .mesh import Mesh, require_mesh


def keep_long(lines: Isolines, least: float) -> Isolines:
    """The lines that are no shorter than `least` >= 0. Cost: O(P)."""
    return replace(lines, **_native.keep_long(_arrays(lines), as_real(least, "least lengths")))


def smooth_lines(mesh: Mesh, lines: Isolines, steps: int, *, cancel: CancelToken | None = None) -> Isolines:
    """Lines with fewer kinks that still run on the surface exactly.

    In each of the `steps`, 0 … 10,000, every point slides along its own edge, half of the way to where the line between
    its neighbours would cross the edge if its two triangles were unfolded. What is straight stays so, and no step makes
    a line longer. A point comes no closer to an end of
    its edge than a hundredth of the edge, unless it was closer, so lines neither cross a vertex nor gather in it. The
    ends of open lines stay where they are. Refused for resampled lines. Cost: O(P steps).
    """
    require_mesh(mesh)
    try:
        count = operator.index(steps)
    except TypeError:
        raise InputError(f"the number of steps has to be a whole number, not {steps!r}") from None
    if not 0 <= count <= 10_000:
        raise InputError(f"the number of steps is {count}, but has to be from 0 to 10000")
    return replace(lines, **_native.smooth_lines(mesh, _arrays(lines), count, as_token(cancel)))


def simplify_lines(lines: Isolines, tolerance: float, *, cancel: CancelToken | None = None) -> Isolines:
    """The lines without the points that matter least, by Douglas and Peucker.

    What is left out lies within `tolerance` >= 0 of the segment that takes its place. The ends of open lines stay, and
    three points or more of closed ones (two of one that had two). Cost: O(P log P) as a rule, O(P²) for spirals.
    """
    distance = as_real(tolerance, "tolerances")
    return replace(lines, **_native.simplify_lines(_arrays(lines), distance, as_token(cancel)))


def resample_lines(lines: Isolines, spacing: float, *, cancel: CancelToken | None = None) -> Isolines:
    """Every line as points evenly spaced along it, from its first point on.

    It gets length / `spacing` segments, rounded, at least 1 if it is open and 3 if it is closed. The points lie on the
    line but on no edge, so `edges` and `t` of the result are empty. Cost: O(P + output).
    """
    step = as_real(spacing, "spacings")
    return replace(lines, **_native.resample_lines(_arrays(lines), step, as_token(cancel)))


def move_lines(lines: Isolines, positions: ArrayLike) -> Isolines:
    """The same lines on vertices that have moved, as on a mesh in another pose: points (1 - t) p[a] + t p[b].

    positions  (V, 3), finite where the lines are. Refused for resampled lines. Cost: O(P).
    """
    places = as_reals(positions, "positions")
    require_shape(places, (None, 3), "positions")
    return replace(lines, **_native.move_lines(_arrays(lines), places))


def _arrays(lines: Isolines) -> Any:
    if not isinstance(lines, Isolines):
        raise InputError(f"this needs Isolines, not {type(lines).__name__}")
    closed = np.ascontiguousarray(lines.closed, dtype=np.bool_)
    return (
        as_reals(lines.points, "points of lines"),
        as_indices(lines.edges, "edges of lines"),
        as_reals(lines.t, "places on edges"),
        as_indices(lines.offsets, "offsets of lines"),
        closed.view(np.uint8),
        as_indices(lines.level, "levels of lines"),
        as_reals(lines.length, "lengths of lines"),
    )
