# SPDX-License-Identifier: GPL-3.0-or-later
"""The look of a ramp as text: how it interpolates, and its stops."""

from __future__ import annotations

import json
from typing import Any

import bpy

from ... import library
from . import material

_MODES = {
    "color_mode": ("RGB", "HSV", "HSL"),
    "interpolation": ("EASE", "CARDINAL", "LINEAR", "B_SPLINE", "CONSTANT"),
    "hue_interpolation": ("NEAR", "FAR", "CW", "CCW"),
}


def read(obj: bpy.types.Object) -> str:
    """Of the object's ramp; before it has one, what `apply` will begin it with."""
    node = material.find_ramp(obj)
    if node is None:
        return obj.dirichlet.ramp_stops
    ramp = node.color_ramp
    look: dict[str, Any] = {name: getattr(ramp, name) for name in _MODES}
    return json.dumps(look | {"stops": [(stop.position, *stop.color) for stop in ramp.elements]})


def apply(obj: bpy.types.Object) -> None:
    """Gives the object's ramp, if it has one, the look that its settings name: `ramp_stops`, if they are one, else
    `ramp_preset`."""
    chosen = obj.dirichlet
    if material.find(obj) is None:
        return
    material.require_own(obj)
    ramp = material.find_ramp(obj).color_ramp
    if not chosen.ramp_stops or not is_look(chosen.ramp_stops):
        material.set_stops(ramp, library.load("ramps").RAMPS[chosen.ramp_preset])
        return
    look = json.loads(chosen.ramp_stops)
    material.set_stops(ramp, [(position, color) for position, *color in look["stops"]])
    for name in _MODES:
        setattr(ramp, name, look[name])


def is_look(text: str) -> bool:
    """Whether `ramp_stops` can be this."""
    if not text:
        return True
    try:
        look = json.loads(text)
        return all(look[name] in modes for name, modes in _MODES.items()) and _are_stops(look["stops"])
    except (ValueError, TypeError, KeyError, RecursionError):
        return False


def _are_stops(stops: Any) -> bool:
    """(position, red, green, blue, alpha), as many as Blender takes."""
    return 0 < len(stops) <= 32 and all(
        len(stop) == 5 and all(isinstance(number, int | float) for number in stop) for stop in stops
    )
