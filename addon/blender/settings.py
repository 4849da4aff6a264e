# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of a property group as plain values.

Settings are all of its properties but pointers, collections (patches) and those marked SKIP_SAVE (a selected row,
another view of a setting): nobody has to list them.
"""

from __future__ import annotations

from typing import Any

import bpy

KINDS = {"BOOLEAN": (bool,), "INT": (int,), "FLOAT": (int, float), "STRING": (str,), "ENUM": (str,)}
_WHOLE = "window_auto"  # switching it off may set the ends of the window, and setting one of those switches it off


def read(group: bpy.types.PropertyGroup) -> dict[str, Any]:
    """By name, in the order of their definition; arrays as tuples."""
    return {
        found.identifier: _plain(getattr(group, found.identifier))
        for found in group.bl_rna.properties
        if found.type in KINDS and not (found.is_skip_save or found.identifier == "name")
    }


def write(group: bpy.types.PropertyGroup, values: dict[str, Any]) -> None:
    """What is equal already is not written: nothing is triggered."""
    whole = [_WHOLE] if _WHOLE in values else []
    for name in (*whole, *values, *whole):
        if _plain(getattr(group, name)) != values[name]:
            setattr(group, name, values[name])


def copy(source: bpy.types.PropertyGroup, target: bpy.types.PropertyGroup) -> None:
    """Gives target every setting that both groups have."""
    shared = read(target).keys()
    write(target, {name: value for name, value in read(source).items() if name in shared})


def _plain(value: Any) -> Any:
    return tuple(value) if isinstance(value, bpy.types.bpy_prop_array) else value
