# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines with all that their data-blocks need, in Blender's float32."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Drawing(NamedTuple):
    """L lines of P points at K levels: line l is points[offsets[l]:offsets[l + 1]]."""

    points: NDArray[np.float32]  # (P, 3)
    offsets: NDArray[np.int64]  # (L + 1,)
    closed: NDArray[np.bool_]  # (L,) the last point joins the first, which is not repeated
    level: NDArray[np.intp]  # (L,) index into levels, ascending
    length: NDArray[np.float64]  # (L,) in object space
    levels: NDArray[np.float64]  # (K,)
    colors: NDArray[np.float32]  # (K, 4) linear
    factors: NDArray[np.float32]  # (K,) of the radius
    radius: float  # of the tubes, in object space

    @property
    def sizes(self) -> NDArray[np.int64]:
        """(L,) points of every line."""
        return np.diff(self.offsets)

    def per_point(self, per_level: NDArray) -> NDArray:
        """(P, ...) of what is given for every level (K, ...)."""
        return np.repeat(per_level[self.level], self.sizes, axis=0)

    def segments(self) -> NDArray[np.uint32]:
        """(S, 2) successive points of every line in its direction, the last and the first of closed ones too."""
        following = np.arange(1, len(self.points) + 1, dtype=np.uint32)
        last = self.offsets[1:] - 1
        following[last] = self.offsets[:-1]
        drawn = np.ones(len(following), bool)
        drawn[last[~self.closed]] = False
        drawn[last[self.closed & (self.sizes == 2)]] = False  # it would be the first segment again
        return np.column_stack((np.arange(len(following), dtype=np.uint32), following))[drawn]


def draw(lines, colors: NDArray[np.float32], factors: NDArray[np.float32], radius: float) -> Drawing:
    """lines: the library's Isolines. Points that coincide in succession once they are rounded to Blender's float32 are
    one, and lines that shrink to a point are left out."""
    points = lines.points.astype(np.float32)
    starts, ends, closed = lines.offsets[:-1], lines.offsets[1:], lines.closed.astype(bool)
    previous = np.arange(len(points)) - 1
    previous[starts] = ends - 1
    kept = (points != points[previous]).any(axis=1)
    kept[starts[~closed]] = True
    sizes = np.add.reduceat(kept, starts, dtype=np.int64) if len(starts) else np.zeros(0, np.int64)
    whole = sizes > 1
    offsets = np.concatenate(([0], np.cumsum(sizes[whole])))
    points = points[kept & np.repeat(whole, ends - starts)]
    return Drawing(
        points, offsets, closed[whole], lines.level[whole], lines.length[whole], lines.levels, colors, factors, radius
    )
