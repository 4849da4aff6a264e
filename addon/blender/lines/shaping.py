# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to isolines once they are extracted, from LineSettings."""

from __future__ import annotations

from dataclasses import dataclass

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library


@dataclass(frozen=True)
class ShapeOptions:
    """Lengths in object space; nothing is done where a number is 0."""

    min_length: float
    smooth: int  # steps
    resample: float
    simplify: float
    bevel: tuple[float, float]  # factors of the thickness at the ends of the window

    def on_surface(self, mesh, lines, cancel):
        """The library's Isolines without short ones, smoothed on the mesh. Their points stay on the edges they cross,
        and so can be moved with them. cancel: the library's CancelToken."""
        surface = library.load()
        if self.min_length > 0:
            lines = surface.keep_long(lines, self.min_length)
        return surface.smooth_lines(mesh, lines, self.smooth, cancel=cancel) if self.smooth > 0 else lines

    def in_space(self, lines, cancel):
        """The library's Isolines with other points: evenly spaced, then as few as the tolerance allows."""
        surface = library.load()
        if self.resample > 0:
            lines = surface.resample_lines(lines, self.resample, cancel=cancel)
        return surface.simplify_lines(lines, self.simplify, cancel=cancel) if self.simplify > 0 else lines

    def factors(self, levels: NDArray[np.float64], window: tuple[float, float]) -> NDArray[np.float32]:
        """(K,) of the thickness at every level: even from one end of the window to the other, and held outside."""
        return np.interp(levels, window, self.bevel).astype(np.float32)


def read_options(settings: bpy.types.PropertyGroup, diagonal: float) -> ShapeOptions:
    """settings: a LineSettings, whose lengths are fractions of the diagonal."""
    return ShapeOptions(
        settings.min_length * diagonal,
        settings.smooth,
        settings.resample * diagonal,
        settings.simplify * diagonal,
        (settings.bevel_low, settings.bevel_high),
    )
