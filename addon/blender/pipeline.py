# SPDX-License-Identifier: GPL-3.0-or-later
"""From a mesh object and its settings to a field and isolines on it.

Plain functions for operators, scripts and tests. They raise the library's DirichletError before they write anything.
"""

from __future__ import annotations

from typing import Any

import bpy

from . import field_task, freshness
from .field_task import FieldResult
from .lines import line_task, result_objects
from .lines.line_task import IsolineResult
from .look import looks, material, ramp
from .mesh import attributes, meshes
from .paint import patches


def solve_field(obj: bpy.types.Object) -> FieldResult:
    """Solves between the patches of `obj.dirichlet` and writes attributes, material and `obj.dirichlet.results`."""
    return write_field(obj, *compute_field(field_task.read(obj)))


def compute_field(task: field_task.FieldTask) -> tuple[field_task.FieldOutcome, list[Any]]:
    """The field, and the library's PatchFacts of its patches. For any thread."""
    return task.compute(), patches.inspect(task.session.mesh, task.patches)


def write_field(obj: bpy.types.Object, outcome: field_task.FieldOutcome, facts: list[Any]) -> FieldResult:
    """Writes a field that is computed, and what was found out about its patches."""
    patches.record_facts(obj, outcome.task.patches, facts)
    result = field_task.write(obj, outcome)
    attributes.show_colors(obj.data)
    return result


def make_isolines(obj: bpy.types.Object) -> IsolineResult:
    """Extracts isolines of the field that the mesh carries, and writes them into the object's result; a locked one
    stays, and another is made."""
    result = result_objects.find_unlocked(obj)
    return write_isolines(obj, line_task.read(obj, result).compute(line_task.read_values(obj)), result)


def write_isolines(
    obj: bpy.types.Object, outcome: line_task.LineOutcome, result: bpy.types.Object | None
) -> IsolineResult:
    """Writes lines that are computed, as line_task.write does, and warns of a field that is older than its patches."""
    doubt = freshness.doubt(obj)
    return line_task.write(obj, outcome, result, (doubt,) if doubt else ())


def update_colors(obj: bpy.types.Object) -> None:
    """Writes `dirichlet_color` anew, as `recolor` does, and shows it."""
    recolor(obj)
    attributes.show_colors(obj.data)


def recolor(obj: bpy.types.Object) -> None:
    """Writes `dirichlet_color` anew from the field that the mesh carries and the ramp as it is now."""
    meshes.require_mesh(obj)
    attributes.require_names(obj)
    values = attributes.read_field(obj.data)
    attributes.write_colors(obj.data, ramp.read_table(obj).apply(values, ramp.limits(values)))


def apply_look(obj: bpy.types.Object) -> None:
    """Gives the ramp of the object's field material the look that the settings name, and the colours through it.

    In Edit Mode the mesh cannot be written: its colours follow when that is left.
    """
    if not material.find_ramp(obj):
        return
    recolored = not obj.data.is_editmode and attributes.has_field(obj.data)
    if recolored:
        attributes.require_names(obj)
    looks.apply(obj)
    if recolored:
        update_colors(obj)
