# SPDX-License-Identifier: GPL-3.0-or-later
"""The legend of a field as points in the unit square, values upwards over the range of the last solve."""

from __future__ import annotations

from contextlib import suppress

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from .. import live
from ..lines import levels
from . import ramp

_STRIPES = 256
_LABEL_HEIGHT = 0.06  # nearer than that, two labels would cover each other

Points = NDArray[np.float32]  # (N, 3), z = 0


def bar(obj: bpy.types.Object) -> tuple[Points, NDArray[np.float32]]:
    """A triangle strip that fills the square, and its colours (N, 4) in sRGB: the ramp's, from bottom to top."""
    results = obj.dirichlet.results
    places = np.linspace(0.0, 1.0, _STRIPES)
    values = results.minimum + places * (results.maximum - results.minimum)
    linear = np.array([ramp.color_at(obj, value) for value in values.tolist()])
    colors = np.ones((_STRIPES, 4), np.float32)
    colors[:, :3] = library.load("ramps").srgb_bytes(linear) / np.float32(255)
    return _across(places), np.repeat(colors, 2, axis=0)


def ticks(obj: bpy.types.Object) -> Points:
    """Pairs of points: a segment across the bar for every level in the field's range."""
    low, high = obj.dirichlet.results.minimum, obj.dirichlet.results.maximum
    chosen = _levels(obj, low, high) if low < high else np.empty(0)
    return _across((chosen[(chosen >= low) & (chosen <= high)] - low) / (high - low if low < high else 1.0))


def _levels(obj: bpy.types.Object, low: float, high: float) -> NDArray[np.float64]:
    """Those previewed, else those that the field's range alone decides, else none."""
    preview = live.preview_of(obj)
    if preview:
        return preview.lines.levels
    with suppress(library.LibraryMissingError), suppress(*library.refusals()):  # Make Isolines says so
        return levels.read_options(obj.dirichlet).choose(low, high)
    return np.empty(0)


def window(obj: bpy.types.Object) -> tuple[float, float]:
    """Places on the bar of the ends of the window."""
    settings = obj.dirichlet
    return (settings.window_low_place, settings.window_high_place) if _has_window(settings) else (0.0, 1.0)


def _has_window(settings: bpy.types.PropertyGroup) -> bool:
    return levels.read_options(settings).window is not None


def shades(window: tuple[float, float]) -> Points:
    """Triangles over what is outside of the window, given by its places on the bar."""
    below, above = _across(np.array([0.0, window[0]])), _across(np.array([window[1], 1.0]))
    return np.concatenate([below[[0, 1, 2, 1, 2, 3]], above[[0, 1, 2, 1, 2, 3]]])


def marks(window: tuple[float, float]) -> Points:
    """Triangles at the right of the bar that point at the window's ends."""
    mark = np.array([(1.0, 0.0, 0.0), (1.5, 0.02, 0.0), (1.5, -0.02, 0.0)], np.float32)
    return np.concatenate([mark + np.array((0.0, place, 0.0), np.float32) for place in window])


def labels(obj: bpy.types.Object) -> list[tuple[float, str]]:
    """Places and texts: the window's ends, and those of the range where there is room left."""
    settings, results = obj.dirichlet, obj.dirichlet.results
    ends = [(0.0, results.minimum), (1.0, results.maximum)]
    if _has_window(settings):
        ends = [
            (settings.window_low_place, settings.window_low),
            (settings.window_high_place, settings.window_high),
            *ends,
        ]
    kept: list[tuple[float, str]] = []
    for place, value in ends:
        if all(abs(place - other) > _LABEL_HEIGHT for other, _ in kept):
            kept.append((place, f"{value:.4g}"))
    return kept


def _across(places: NDArray[np.float64]) -> Points:
    """(2N, 3) the left and the right end of every place."""
    points = np.zeros((2 * len(places), 3), np.float32)
    points[1::2, 0] = 1.0
    points[:, 1] = np.repeat(places, 2)
    return points
