# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as what a graphics card draws: points, colours and the segments between them."""

from __future__ import annotations

from typing import NamedTuple

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ..names import LENGTH
from .outputs import curve
from .outputs.drawing import draw


class Segments(NamedTuple):
    """The lines that Make Isolines would make, as an indexed list of segments."""

    points: NDArray[np.float32]  # (P, 3) in object space
    colors: NDArray[np.float32]  # (P, 4) of the points' levels, in sRGB as screens expect
    segments: NDArray[np.uint32]  # (S, 2) every pair of successive points once, in the direction of the line


def segments(lines, colors: NDArray[np.float32]) -> Segments:
    """lines: the library's Isolines; colors: (K, 4) linear, one per level. Cost: O(P), without a loop over points."""
    drawing = draw(lines, colors, np.ones(len(colors), np.float32), radius=0.0)
    shown = colors.copy()
    shown[:, :3] = library.load("ramps").srgb_bytes(colors[:, :3]) / np.float32(255)
    return Segments(drawing.points, drawing.per_point(shown), drawing.segments())


def is_drawn_by(result: bpy.types.Object, lines) -> bool:
    """Whether the result has tubes along just these lines: then lines drawn over them are seen twice."""
    tubes = result.type == curve.TYPE and result.data.bevel_depth > 0
    return tubes and np.array_equal(result.data.get(LENGTH, ()), lines.length) and _begin_alike(result.data, lines)


def _begin_alike(drawn: bpy.types.Curve, lines) -> bool:
    """Whether first and last line begin where they are drawn: of a mesh that was moved, all lengths are the same."""
    if not drawn.splines:
        return True
    ends = (0, lines.offsets[:2]), (-1, lines.offsets[-2:])
    return all(_passes(lines.points[slice(*places)], drawn.splines[k].points[0].co[:3]) for k, places in ends)


def _passes(points: NDArray[np.float64], place: tuple[float, ...]) -> bool:
    return bool((points.astype(np.float32) == np.array(place, np.float32)).all(axis=1).any())
