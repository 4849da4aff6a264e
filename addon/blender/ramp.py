# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of a field, through the ramp that the user edits."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from .. import library
from . import material

_SAMPLES = 1024


def limits(values: NDArray[np.float64]) -> tuple[float, float]:
    """What the ends of the ramp stand for: the range of the defined values, widened when it is one number alone, so
    that a constant field takes the middle of the ramp."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    margin = 0.0 if high > low else max(1.0, abs(low))
    return low - margin, high + margin


def colors(obj: bpy.types.Object, values: NDArray[np.float64], ends: tuple[float, float]) -> NDArray[np.float32]:
    """(..., 4) linear RGBA of values (...): neutral grey where NaN, the nearer end of the ramp outside `ends`.

    The ramp is that of the object's field material, else the preset chosen for the object.
    """
    ramps = library.load("ramps")
    low, high = ends
    ramp = material.find_ramp(obj)
    if ramp is None:
        linear = ramps.apply_ramp(values, low, high, obj.dirichlet.ramp_preset)
        return np.concatenate([linear, np.ones_like(linear[..., :1])], axis=-1, dtype=np.float32)
    places = (values - low) / (high - low)
    linear = evaluate(ramp.color_ramp, places)
    linear[np.isnan(values)] = (*ramps.UNDEFINED_COLOR, 1.0)
    return linear


def evaluate(ramp: bpy.types.ColorRamp, places: NDArray[np.float64]) -> NDArray[np.float32]:
    """(..., 4) RGBA of a ColorRamp, sampled once: evenly, and on both sides of every stop, where it may jump."""
    stops = np.array([stop.position for stop in ramp.elements], np.float32)
    samples = np.concatenate([np.linspace(0, 1, _SAMPLES, dtype=np.float32), stops, np.nextafter(stops, np.float32(0))])
    samples = np.unique(samples)
    table = np.array([ramp.evaluate(sample) for sample in samples.tolist()])
    return np.stack([np.interp(places, samples, channel) for channel in table.T], axis=-1).astype(np.float32)
