# SPDX-License-Identifier: GPL-3.0-or-later
"""The presets that come with the add-on."""

import json
from typing import Any, NamedTuple


class Preset(NamedTuple):
    label: str
    description: str
    setup: dict[str, Any]


def _stops(interpolation: str, *stops: tuple[float, ...]) -> str:
    """(place, red, green, blue) each, linear."""
    look = {"color_mode": "RGB", "interpolation": interpolation, "hue_interpolation": "NEAR"}
    return json.dumps(look | {"stops": [(*stop, 1.0) for stop in stops]})


_LAND = _stops(
    "LINEAR",
    (0.0, 0.02, 0.10, 0.24),
    (0.3, 0.25, 0.50, 0.55),
    (0.32, 0.09, 0.26, 0.06),
    (0.55, 0.45, 0.42, 0.12),
    (0.8, 0.30, 0.15, 0.06),
    (1.0, 0.85, 0.83, 0.80),
)
_ZEBRA = _stops("CONSTANT", *((k / 16, *(3 * (0.01 if k % 2 else 0.85,))) for k in range(16)))
_BAND = _stops(
    "CONSTANT", (0.0, 0.02, 0.03, 0.05), (0.4, 0.9, 0.45, 0.02), (0.6, 0.02, 0.03, 0.05)
)  # fmt: skip
_PAPER = _stops("LINEAR", (0.0, 0.80, 0.76, 0.68), (1.0, 0.88, 0.85, 0.78))

PRESETS = {
    "TOPOGRAPHIC": Preset(
        "Topographic",
        "The colours of a map of land and sea, and a contour line at every twentieth of the range",
        {"ramp_preset": "rainbow", "ramp_stops": _LAND, "levels_mode": "EVEN", "count": 19, "window_auto": True,
         "bevel_depth": 0.001},
    ),
    "ZEBRA_STRIPES": Preset(
        "Zebra Stripes",
        "Sixteen stripes, black and white by turns, with a line at every border between them",
        {"ramp_preset": "grey", "ramp_stops": _ZEBRA, "levels_mode": "EVEN", "count": 15, "window_auto": True,
         "bevel_depth": 0.001},
    ),
    "WINDOW_BAND": Preset(
        "Window Band",
        "Lines only in a window around the middle of the range, whose band stands out",
        {"ramp_preset": "rainbow", "ramp_stops": _BAND, "levels_mode": "EVEN", "count": 9, "window_low_place": 0.4,
         "window_high_place": 0.6, "bevel_depth": 0.0015},
    ),
    "FINE_ENGRAVING": Preset(
        "Fine Engraving",
        "Very many hair-thin lines on paper, as in a copperplate",
        {"ramp_preset": "grey", "ramp_stops": _PAPER, "levels_mode": "EVEN", "count": 120, "window_auto": True,
         "bevel_depth": 0.0004},
    ),
}  # fmt: skip
