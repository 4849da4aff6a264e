# SPDX-License-Identifier: GPL-3.0-or-later
"""Colour ramps for fields. One table for files, pictures and Blender."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Color = tuple[float, float, float]

#: Name -> stops (position in [0, 1], *linear* RGB), piecewise linear in between, as in Blender's ColorRamp.
RAMPS: dict[str, tuple[tuple[float, Color], ...]] = {
    "rainbow": (
        (0.0, (0.0, 0.0, 0.8)),
        (0.25, (0.0, 0.6, 0.9)),
        (0.5, (0.0, 0.7, 0.05)),
        (0.75, (0.95, 0.8, 0.0)),
        (1.0, (0.8, 0.0, 0.0)),
    ),
    "viridis": (
        (0.0, (0.055, 0.002, 0.09)),
        (0.25, (0.04, 0.07, 0.24)),
        (0.5, (0.015, 0.26, 0.26)),
        (0.75, (0.13, 0.56, 0.12)),
        (1.0, (0.97, 0.8, 0.025)),
    ),
    "grey": ((0.0, (0.01, 0.01, 0.01)), (0.5, (0.2, 0.2, 0.2)), (1.0, (0.9, 0.9, 0.9))),
    "red-blue": (
        (0.0, (0.5, 0.01, 0.015)),
        (0.25, (0.82, 0.2, 0.13)),
        (0.5, (0.85, 0.85, 0.85)),
        (0.75, (0.13, 0.3, 0.7)),
        (1.0, (0.01, 0.04, 0.4)),
    ),
}

#: Linear RGB of a vertex whose field is undefined.
UNDEFINED_COLOR: Color = (0.21, 0.21, 0.21)


def apply_ramp(
    values: NDArray[np.floating[Any]], low: float, high: float, name: str = "rainbow"
) -> NDArray[np.float64]:
    """Linear RGB (..., 3) of values (...) on the ramp `name` spread over [low, high].

    Values outside take the colour of the nearer end, NaN takes UNDEFINED_COLOR; where low == high all is mid-ramp.
    """
    values = np.asarray(values, dtype=np.float64)
    if not np.isfinite(high - low):
        values, low, high = values / 2, low / 2, high / 2
    place = (values - low) / (high - low) if high > low else np.where(np.isnan(values), values, 0.5)
    stops, colors = zip(*RAMPS[name])
    channels = [np.interp(place, stops, channel) for channel in zip(*colors)]
    return np.where(np.isnan(values)[..., None], UNDEFINED_COLOR, np.stack(channels, axis=-1))


def srgb_bytes(linear: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Linear RGB in [0, 1] as the sRGB bytes that files and screens expect (IEC 61966-2-1)."""
    linear = np.clip(linear, 0.0, 1.0)
    encoded: NDArray[np.float64] = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.rint(255 * encoded).astype(np.uint8)
