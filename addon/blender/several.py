# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and isolines of several objects: all are computed before anything is written, so that a refusal, which names
its object, leaves every one of them as it was."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import NamedTuple

import bpy

from .. import library
from . import field_task, line_task, pipeline, result_objects
from .pipeline import Progress


class Made(NamedTuple):
    """What was made, to be reported."""

    results: list  # FieldResult or IsolineResult, one per object
    summary: str
    warnings: tuple[str, ...]


def solve_fields(objects: Sequence[bpy.types.Object], *, progress: Progress = lambda done: None) -> Made:
    """Solves for the field of every object. A mesh that several of them share is solved once, with the patches of the
    first of them. Raises what `pipeline.solve_field` raises."""
    owners, warnings = _one_per_mesh(objects)
    outcomes = []
    for obj in owners:
        with _naming(obj, owners):
            outcomes.append(field_task.read(obj).compute())
        progress(len(outcomes) / (len(owners) + 1))
    made = [pipeline.write_field(obj, outcome) for obj, outcome in zip(owners, outcomes)]
    reports = [result.field.report for result in made]
    seconds = sum(report.total_seconds for report in reports)
    summary = (
        f"{len(made)} fields: {sum(report.unknowns for report in reports)} of "
        f"{sum(report.vertices for report in reports)} vertices solved in {1000 * seconds:.1f} ms"
    )
    return Made(made, summary if len(made) > 1 else reports[0].summary(), (*warnings, *_warnings(owners, made)))


def make_isolines(objects: Sequence[bpy.types.Object], *, progress: Progress = lambda done: None) -> Made:
    """Draws the isolines of every object, each by its own settings. Raises what `pipeline.make_isolines` raises."""
    outcomes = []
    for obj in objects:
        with _naming(obj, objects):
            outcomes.append(line_task.read(obj).compute(line_task.read_values(obj)))
        progress(len(outcomes) / (len(objects) + 1))
    made = [line_task.write(obj, outcome, result_objects.find_unlocked(obj)) for obj, outcome in zip(objects, outcomes)]
    count = sum(len(result.lines) for result in made)
    closed = sum(int(result.lines.closed.sum()) for result in made)
    summary = f"{count} isolines on {len(made)} objects, {closed} closed" if len(made) > 1 else made[0].summary
    return Made(made, summary, tuple(_warnings(objects, made)))


def _one_per_mesh(objects: Iterable[bpy.types.Object]) -> tuple[list[bpy.types.Object], list[str]]:
    """The first object of every mesh, and who is left out."""
    owner: dict[bpy.types.Mesh, bpy.types.Object] = {}
    warnings = []
    for obj in objects:
        first = owner.setdefault(obj.data, obj)
        if first != obj:
            warnings.append(
                f"'{first.name}' and '{obj.name}' share mesh '{obj.data.name}': the patches of '{first.name}' were used"
            )
    return list(owner.values()), warnings


@contextmanager
def _naming(obj: bpy.types.Object, objects: Sequence[bpy.types.Object]) -> Iterator[None]:
    """Says whose refusal it is, where there are several that it could be and it does not say so itself."""
    try:
        yield
    except library.load().DirichletError as error:
        if len(objects) == 1 or f"object '{obj.name}'" in str(error):
            raise
        raise type(error)(f"object '{obj.name}': {error}") from error


def _warnings(objects: Sequence[bpy.types.Object], made: Iterable) -> Iterator[str]:
    for obj, result in zip(objects, made):
        yield from (f"'{obj.name}': {warning}" if len(objects) > 1 else warning for warning in result.warnings)
