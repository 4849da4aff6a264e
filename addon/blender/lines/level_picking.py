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

    In another mode the list begins anew with that value alone, and becomes the mode. Returns the value.
    Raises InputError: no field, one that is undefined there, or a list that is not of numbers.
    """
    meshes.require_mesh(obj)
    values = line_task.read_values(obj)
    level = library.load().level_through_point(sessions.open_session(obj).mesh, values, location)
    settings = obj.dirichlet
    listed = settings.levels_list.strip() if settings.levels_mode == "LIST" else ""
    if listed:
        levels.parse_levels(listed)
    picked = str(np.float32(level))  # with as many digits as tell the field's numbers apart
    settings.levels_list = f"{listed.rstrip(',;')}, {picked}" if listed else picked
    settings.levels_mode = "LIST"
    return level
