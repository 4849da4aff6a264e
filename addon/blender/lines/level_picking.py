# SPDX-License-Identifier: GPL-3.0-or-later
"""The level whose line runs through a point of the surface."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import bpy

from ... import library
from ..held import Held
from ..mesh import sessions
from ..work import Made, Step, Work, stopping
from . import levels, line_task


def add_level(obj: bpy.types.Object, location: Sequence[float]) -> Work:
    """Adds the field's value at the mesh's nearest point to `location`, in object space, to the listed levels.

    In another mode the list begins with the levels of that mode, so that no line is lost, and becomes the mode. Returns
    Made, whose result is the value. Raises InputError: no field, one that is undefined there, a list that is not of
    numbers, or levels that cannot be had.
    """
    held, surface = Held(obj), library.load()
    session = yield from sessions.opening(held)
    obj = held.find_mesh()
    values, settings, cancel = line_task.read_values(obj), obj.dirichlet, surface.CancelToken()
    listed = settings.levels_list.strip().rstrip(",;")
    options = None if settings.levels_mode == "LIST" else levels.read_options(settings)
    if listed and not options:
        levels.parse_levels(listed)

    def find() -> tuple[float, Any]:
        level = surface.level_through_point(session.mesh, values, tuple(location))
        return level, options.choose_on(session.mesh, values, cancel) if options else ()

    with stopping(cancel.cancel):
        level, others = yield Step(held.name, 0.5, find)
    settings = held.find_mesh().dirichlet
    if options:
        listed = ", ".join(map(levels.written, others))
    settings.levels_list = ", ".join(filter(None, (listed, levels.written(level))))
    settings.levels_mode = "LIST"
    return Made([level], "")
