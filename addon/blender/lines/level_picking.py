# SPDX-License-Identifier: GPL-3.0-or-later
"""The level whose line runs through a point of the surface."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np

from ... import library
from ..mesh import meshes, sessions
from . import levels, line_task


def add_level(obj: bpy.types.Object, location: Sequence[float]) -> float:
    """Adds the field's value at the mesh's nearest point to `location`, in object space, to the listed levels.

    In another mode the list begins with the levels of that mode, so that no line is lost, and becomes the mode. Returns
    the value. Raises InputError: no field, one that is undefined there, a list that is not of numbers, or levels that
    cannot be had.
    """
    meshes.require_mesh(obj)
    values, mesh, settings = line_task.read_values(obj), sessions.open_session(obj).mesh, obj.dirichlet
    level = library.load().level_through_point(mesh, values, location)
    listed = settings.levels_list.strip().rstrip(",;")
    if settings.levels_mode != "LIST":
        listed = ", ".join(map(_written, levels.read_options(settings).choose_on(mesh, values)))
    elif listed:
        levels.parse_levels(listed)
    settings.levels_list = f"{listed}, {_written(level)}" if listed else _written(level)
    settings.levels_mode = "LIST"
    return level


def _written(level: float) -> str:
    """With as many digits as tell the field's numbers apart."""
    return str(np.float32(level))
