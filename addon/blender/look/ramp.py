# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of a field, through the ramp that the user edits."""

from __future__ import annotations

from functools import cached_property

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from . import material

_SAMPLES = 1024
_PLACES = 1 << 16  # of the table that many values are looked up in


def limits(values: NDArray[np.floating]) -> tuple[float, float]:
    """What the ends of the ramp stand for: the range of the defined values, widened when it is one number alone, so
    that a constant field takes the middle of the ramp. NaN without defined values."""
    low, high = (float(end.reduce(values, initial=np.nan)) for end in (np.fmin, np.fmax))  # passes NaN over, no copy
    margin = 0.0 if high > low else max(1.0, abs(low))
    return low - margin, high + margin


class ColorTable:
    """A ramp as numbers, so that any thread can apply it.

    samples: (S,) places from 0 to 1, ascending; colors: (S, 4) linear RGBA there, linear in between; jumps: (J,) places
    where the colour changes at once; undefined: RGB where the field is NaN.
    """

    def __init__(self, samples, colors, jumps, undefined: tuple[float, float, float]) -> None:
        self._samples, self._colors, self._jumps = samples, colors, jumps
        self._undefined = (*undefined, 1.0)

    def evaluate(self, places: NDArray[np.float64]) -> NDArray[np.float32]:
        """(..., 4) at places (...)."""
        channels = [np.interp(places, self._samples, channel) for channel in self._colors.T]
        return np.stack(channels, axis=-1, dtype=np.float32)

    @cached_property
    def _table(self) -> NDArray[np.float32]:
        return self.evaluate(np.linspace(0, 1, _PLACES))

    def apply(self, values: NDArray[np.floating], ends: tuple[float, float]) -> NDArray[np.float32]:
        """(N, 4) of values (N,): the nearer end of the ramp outside `ends`, the colour for undefined where NaN.

        To a 65536th of the ramp, and exact where it jumps.
        """
        low, high = ends
        places = (values.astype(np.float64) - low) / (high - low)
        undefined = np.isnan(places)
        if undefined.any():
            places[undefined] = 0
        nearest = np.clip(places * (_PLACES - 1) + 0.5, 0, _PLACES - 1).astype(np.intp)
        colors = self._table.take(nearest, axis=0)
        for jump in self._jumps:
            near = np.abs(places - jump) < 1 / _PLACES
            colors[near] = self.evaluate(places[near])
        colors[undefined] = self._undefined
        return colors


def read_table(obj: bpy.types.Object) -> ColorTable:
    """The ramp of the object's field material, else the preset chosen for the object."""
    ramps = library.load("ramps")
    node = material.find_ramp(obj)
    if node:
        return ColorTable(*_sample(node.color_ramp), ramps.UNDEFINED_COLOR)
    places = np.linspace(0, 1, _SAMPLES)
    linear = ramps.apply_ramp(places, 0.0, 1.0, obj.dirichlet.ramp_preset)
    return ColorTable(places, np.column_stack([linear, np.ones_like(places)]), (), ramps.UNDEFINED_COLOR)


def color_at(obj: bpy.types.Object, value: float) -> tuple[float, float, float]:
    """Linear RGB of one value in the range of the last solve, cheap enough to draw with; grey when never solved."""
    node, results = material.find_ramp(obj), obj.dirichlet.results
    if node is None or not results.solved:
        return (0.5, 0.5, 0.5)
    width = results.maximum - results.minimum
    return tuple(node.color_ramp.evaluate((value - results.minimum) / width if width > 0 else 0.5)[:3])


def _sample(ramp: bpy.types.ColorRamp) -> tuple[NDArray[np.float32], NDArray[np.float64], list[float]]:
    """Sampled once: evenly, and on both sides of every stop, where it may jump; and the places where it does."""
    stops = np.array([stop.position for stop in ramp.elements], np.float32)
    before = np.nextafter(stops, np.float32(0))
    samples = np.unique(np.concatenate([np.linspace(0, 1, _SAMPLES, dtype=np.float32), stops, before]))
    colors = np.array([ramp.evaluate(sample) for sample in samples.tolist()])
    steps = np.abs(colors[np.searchsorted(samples, stops)] - colors[np.searchsorted(samples, before)]).max(axis=1)
    return samples, colors, np.unique(stops[steps > 1e-3]).tolist()
