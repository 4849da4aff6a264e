# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and isolines of several objects: all are computed before anything is written, so that a refusal, which names
its object, leaves every one of them as it was. Each is a work, see work.py."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from itertools import accumulate
from typing import Any, NamedTuple

import bpy

from .. import library
from ..language import counted, say
from ..sentences import told
from . import field_task, pipeline
from .held import Held
from .lines import line_task, result_objects
from .mesh import sessions
from .work import Made, Step, Work, stopping


def solve_fields(objects: Sequence[bpy.types.Object]) -> Work:
    """Solves for the field of every object; returns Made. A mesh that several of them share is solved once, with the
    patches of the first of them. Raises what `pipeline.solve_field` raises."""
    owners, warnings = _one_per_mesh(objects)
    held, outcomes = [Held(obj) for obj in owners], []
    for one, part in zip(held, _parts(held)):
        with _naming(one.name, held):
            session = yield from sessions.opening(one, part.start)
            task = field_task.read(one.find_mesh(), session=session)
            with stopping(task.interrupt):
                outcomes.append(
                    (yield Step(one.name, part.opened, partial(pipeline.compute_field, task), say("solving")))
                )
    owners = [one.find_mesh() for one in held]
    made = [pipeline.write_field(obj, *outcome) for obj, outcome in zip(owners, outcomes)]
    summary = _summary([result.field.report for result in made])
    return Made(made, summary, (*warnings, *_warnings(owners, made)))


def make_isolines(objects: Sequence[bpy.types.Object]) -> Work:
    """Draws the isolines of every object, each by its own settings; returns Made. Raises what
    `pipeline.make_isolines` raises."""
    return _draw([(Held(obj), result_objects.find_unlocked) for obj in objects])


def refresh(results: Sequence[bpy.types.Object]) -> Work:
    """Makes the lines of results anew: by the settings of its mesh object if it is the bound one, else by its own;
    returns Made. Raises InputError for one that is locked or without a mesh object, and what `make_isolines` raises."""
    return _draw([(Held(result_objects.require_source(one)), partial(_still, Held(one))) for one in results])


def _still(held: Held, source: bpy.types.Object) -> bpy.types.Object:
    """The result that is held, if it may still be changed."""
    result = held.find()
    result_objects.require_source(result)
    return result


def _draw(pairs: Sequence[tuple[Held, Callable[[bpy.types.Object], bpy.types.Object | None]]]) -> Work:
    """pairs: mesh objects, and what finds the result of each at any time; None for one that is still to be made."""
    held, outcomes = [one for one, _ in pairs], []
    for (one, find_result), part in zip(pairs, _parts(held)):
        with _naming(one.name, held):
            session = yield from sessions.opening(one, part.start)
            obj = one.find_mesh()
            task, values = line_task.read(obj, find_result(obj), session=session), line_task.read_values(obj)
            with stopping(task.interrupt):
                outcomes.append(
                    (yield Step(one.name, part.opened, partial(task.compute, values), say("tracing lines")))
                )
    objects = [one.find_mesh() for one in held]
    results = [find_result(obj) for obj, (_, find_result) in zip(objects, pairs)]
    made = [pipeline.write_isolines(*each) for each in zip(objects, outcomes, results)]
    lines = counted(sum(len(result.lines) for result in made), "1 isoline", "{count} isolines")
    closed = sum(int(result.lines.closed.sum()) for result in made)
    summary = say("{lines} on {count} objects, {closed} closed", lines=lines, count=len(made), closed=closed)
    return Made(made, summary if len(made) > 1 else made[0].summary, tuple(_warnings(objects, made)))


class _Part(NamedTuple):
    """Of the whole work, from 0 to 1: where that for an object begins, and where its mesh is the library's."""

    start: float
    opened: float


def _parts(held: Sequence[Held]) -> Iterator[_Part]:
    """One per object: every vertex is as much work."""
    sizes = [len(one.find_mesh().data.vertices) for one in held]
    starts = accumulate(sizes, initial=0)
    whole = max(sum(sizes), 1)
    for start, size in zip(starts, sizes):
        yield _Part(start / whole, (start + 0.3 * size) / whole)


def _summary(reports: Sequence[Any]) -> str:
    """One line on the fields of these SolveReports."""
    values = {
        "count": len(reports),
        "unknowns": sum(report.unknowns for report in reports),
        "vertices": sum(report.vertices for report in reports),
        "milliseconds": 1000 * sum(report.total_seconds for report in reports),
        "low": min(report.minimum for report in reports),
        "high": max(report.maximum for report in reports),
        "residual": max(report.relative_residual for report in reports),
    }
    if len(reports) > 1:
        return say("{count} fields: {unknowns} of {vertices} vertices solved in {milliseconds:.1f} ms", **values)
    summary = say(
        "{unknowns} of {vertices} vertices solved in {milliseconds:.1f} ms, values {low:.6g} to {high:.6g}, "
        "relative residual {residual:.1e}",
        **values,
    )
    report = reports[0]
    return f"{summary}; {report.laplacian}: {report.reason}" if report.reason else summary


def _one_per_mesh(objects: Iterable[bpy.types.Object]) -> tuple[list[bpy.types.Object], list[str]]:
    """The first object of every mesh, and who is left out."""
    owner: dict[bpy.types.Mesh, bpy.types.Object] = {}
    warnings = []
    for obj in objects:
        first = owner.setdefault(obj.data, obj)
        if first != obj:
            warnings.append(
                say(
                    "'{first}' and '{other}' share mesh '{mesh}': the patches of '{first}' were used",
                    first=first.name,
                    other=obj.name,
                    mesh=obj.data.name,
                )
            )
    return list(owner.values()), warnings


@contextmanager
def _naming(name: str, held: Sequence[Held]) -> Iterator[None]:
    """Says whose refusal it is, where there are several that it could be and it does not say so itself."""
    try:
        yield
    except library.load().DirichletError as error:
        if len(held) == 1 or f"'{name}'" in str(error):  # in any language
            raise
        raise type(error)(say("object '{name}': {reason}", name=name, reason=told(error))) from error


def _warnings(objects: Sequence[bpy.types.Object], made: Iterable) -> Iterator[str]:
    for obj, result in zip(objects, made):
        yield from (f"'{obj.name}': {warning}" if len(objects) > 1 else warning for warning in result.warnings)
