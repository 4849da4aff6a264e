# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as what a graphics card draws: points, colours and the segments between them."""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ..names import LENGTH
from .outputs import curve
from .outputs.drawing import Drawing, draw


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


class Shown:
    """Lines that are shown until they change, however often that is."""

    def __init__(self, lines: Any) -> None:
        """lines: the library's Isolines."""
        self.lines = lines

    @cached_property
    def drawing(self) -> Drawing:
        """Without mere points."""
        return draw(self.lines, np.empty((0, 4), np.float32), np.empty(0, np.float32), radius=0.0)


def is_drawn_by(result: bpy.types.Object, shown: Shown) -> bool:
    """Whether the result has tubes along just these lines: then lines drawn over them are seen twice. Cost: O(L), but
    for the first time that there are mere points among them."""
    lines: Any = shown.lines
    if result.type != curve.TYPE or result.data.bevel_depth <= 0:
        return False
    lengths = np.array(result.data.get(LENGTH, ()))
    if len(lengths) < len(lines.length) and np.isclose(lengths.sum(), lines.length.sum()):
        lines = shown.drawing
    return np.array_equal(lengths, lines.length) and _begin_alike(result.data, lines)


def _begin_alike(drawn: bpy.types.Curve, lines) -> bool:
    """Whether first and last line begin where they are drawn: of a mesh that was moved, all lengths are the same."""
    if not drawn.splines:
        return True
    ends = (0, lines.offsets[:2]), (-1, lines.offsets[-2:])
    return all(_passes(lines.points[slice(*places)], drawn.splines[k].points[0].co[:3]) for k, places in ends)


def _passes(points: NDArray[np.float64], place: tuple[float, ...]) -> bool:
    return bool((points.astype(np.float32) == np.array(place, np.float32)).all(axis=1).any())
