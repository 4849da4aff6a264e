# SPDX-License-Identifier: GPL-3.0-or-later
"""All settings of an object, to copy, to keep as a preset file and to bring back. The stops of its ramp go with them.

A preset file is one Python literal, so that reading one runs nothing.
"""

from __future__ import annotations

import ast
import os
from pathlib import Path
from pprint import pformat
from typing import Any

import bpy

from .. import library
from ..language import say
from . import settings
from .look import looks

Setup = dict[str, Any]  # by the name of the setting; not all need be there
_PLACES = {"window_low_place", "window_high_place"}  # in the field's range


def read(obj: bpy.types.Object) -> Setup:
    return settings.read(obj.dirichlet) | {"ramp_stops": looks.read(obj)}


def write(obj: bpy.types.Object, setup: Setup) -> None:
    """Sets what the setup holds. A ramp comes with its stops, also where the user has edited them.

    Raises InputError, before anything is written, naming a setting that does not exist or cannot take its value, and
    for a window in the range of a field that is not there.
    """
    group = obj.dirichlet
    for name, value in setup.items():
        _require(group, name, value)
    if setup.keys() & _PLACES:
        _require_range(obj)
        group.window_auto = True  # an end stops before the other one: before those it is to have, not those it had
    if "ramp_preset" in setup:
        setup = {"ramp_stops": ""} | setup
    settings.write(group, {name: value for name, value in setup.items() if name != "ramp_stops"})
    if setup.get("ramp_stops", looks.read(obj)) != looks.read(obj):
        group.ramp_stops = setup["ramp_stops"]


def load(path: Path) -> Setup:
    """Raises InputError when the file cannot be read or is no setup."""
    try:
        setup = ast.literal_eval(path.read_text(encoding="utf-8"))
        if isinstance(setup, dict):
            return setup
        reason = say("it does not hold settings")
    except (OSError, SyntaxError, ValueError, TypeError, RecursionError, MemoryError) as error:
        reason = str(error) or type(error).__name__
    raise library.load().InputError(say("preset '{name}' cannot be read: {reason}", name=path.stem, reason=reason))


def save(setup: Setup, path: Path) -> None:
    """Raises OSError; the file is there whole or not at all."""
    part = path.with_name(path.name + ".part")
    try:
        part.write_text(pformat(setup, sort_dicts=False) + "\n", encoding="utf-8")
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def _require_range(obj: bpy.types.Object) -> None:
    if not obj.dirichlet.results.solved:
        raise library.load().InputError(
            say(
                "object '{object}' has no field whose range the window can be a part of: run Solve Field first",
                object=obj.name,
            )
        )


def _require(group: bpy.types.PropertyGroup, name: str, value: Any) -> None:
    found = group.bl_rna.properties.get(name) if isinstance(name, str) else None
    if found is None or found.type not in settings.KINDS:
        raise library.load().InputError(
            say("there is no setting {name!r}: the preset is of another version", name=name)
        )
    length = getattr(found, "array_length", 0)
    values = value if length and isinstance(value, tuple) else (value,)
    right = len(values) == (length or 1) and all(type(one) in settings.KINDS[found.type] for one in values)
    if found.type == "ENUM":
        right = right and value in found.enum_items
    if not right or (name == "ramp_stops" and not looks.is_look(value)):
        raise library.load().InputError(say("setting '{name}' cannot be {value!r}", name=name, value=value))
