# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows one object: what is pending, computed and shown."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from enum import IntFlag
from itertools import count
from time import perf_counter
from typing import Any, NamedTuple

import bpy
import numpy as np
from numpy.typing import NDArray

from .. import library
from . import field_task, pipeline
from .lines import line_task, result_objects
from .mesh import attributes, sessions

_INSPECTED = 200_000  # vertices up to which the patches of the list are looked at on every stroke
_PREVIEW = ""
_versions = count(1)


class Change(IntFlag):
    """What is to be done anew. A new field has new colours and lines."""

    LINES = 1
    COLORS = 2
    FIELD = 4


class Preview(NamedTuple):
    """Lines to draw in the viewport."""

    lines: Any  # the library's Isolines, in object space
    colors: NDArray[np.float32]  # (K, 4) linear, one per level
    version: int  # another one after every change


class _Work(NamedTuple):
    """What to compute; nothing of Blender's is in it."""

    field: field_task.FieldTask | None
    lines: dict[str, line_task.LineTask]  # by the name of the result; _PREVIEW: those shown alone
    values: NDArray[np.float32] | None  # (V,) for the lines, unless they are of the new field

    def compute(self) -> tuple[field_task.FieldOutcome | None, dict[str, line_task.LineOutcome], str]:
        """Field, lines, and why some are missing: levels that cannot be had hold neither field nor other lines back."""
        field, lines, problem = self.field.compute() if self.field else None, {}, ""
        values = field.values if field else self.values
        for name, task in self.lines.items():
            try:
                lines[name] = task.compute(values)
            except library.refusals() as error:
                problem = str(error)
        return field, lines, problem


class Follower:
    def __init__(self) -> None:
        self.name = ""  # the object's when last seen
        self.pending = Change(0)
        self.resting = True  # nobody paints, as far as known
        self.noted = 0.0  # when the last change came
        self.job: Future | None = None
        self.preview: Preview | None = None
        self.seconds: dict[str, float] = {}
        self._begun = 0.0

    def note(self, what: Change, *, resting: bool) -> None:
        self.pending |= what
        self.noted = perf_counter()
        if Change.FIELD in what:
            self.resting = resting

    def is_computing(self) -> bool:
        return self.job is not None and not self.job.done()

    def due(self) -> Change:
        """What can be done now: paint is not read under a moving brush, lines and colours need not wait."""
        return self.pending if self.resting else self.pending & ~Change.FIELD

    def has_something_to_do(self) -> bool:
        return not self.is_computing() and (self.job is not None or bool(self.due()))

    def begin(
        self, obj: bpy.types.Object, pool: ThreadPoolExecutor | None, depsgraph: bpy.types.Depsgraph | None = None
    ) -> None:
        """Starts on what is due, unless something is being computed. Without a pool it is computed here; depsgraph:
        that of a handler."""
        what = self.due()
        if self.job or not what:
            return
        self.pending &= ~what
        if obj.mode == "EDIT":
            return  # leaving it is a change again
        self._begun = perf_counter()
        job: Future = Future()
        try:
            work = self._read(obj, what, depsgraph)
            if pool:
                job = pool.submit(work.compute)
            else:
                job.set_result(work.compute())
        except library.refusals() as error:
            job.set_exception(error)
        self.job = job

    def finish(self, obj: bpy.types.Object) -> None:
        """Writes what has been computed, waiting for it, unless it is out of date already."""
        if not self.job:
            return
        job, self.job = self.job, None
        try:
            field, lines, problem = job.result()
            if problem:
                self.preview = None
            if not self.pending & (Change.FIELD if field else Change.LINES) and obj.mode != "EDIT":
                self._write(obj, field, lines)
        except library.refusals() as error:
            problem, self.preview = str(error), None
        if obj.dirichlet.results.problem != problem:
            obj.dirichlet.results.problem = problem

    def _read(self, obj: bpy.types.Object, what: Change, depsgraph: bpy.types.Depsgraph | None) -> _Work:
        field = field_task.read(obj, depsgraph) if Change.FIELD in what else None
        if not field and not attributes.has_field(obj.data):
            return _Work(None, {}, None)
        if Change.COLORS in what and not field:
            pipeline.update_colors(obj)
        lines: dict[str, line_task.LineTask] = {}
        if what & (Change.FIELD | Change.LINES):
            lines = _read_lines(obj, field.session if field else sessions.open_session(obj), depsgraph)
        return _Work(field, lines, line_task.read_values(obj) if lines and not field else None)

    def _write(self, obj: bpy.types.Object, field, lines: dict[str, line_task.LineOutcome]) -> None:
        self.seconds = {"wait": self._begun - self.noted}
        if field:
            write = pipeline.write_field if len(obj.data.vertices) <= _INSPECTED else field_task.write
            write(obj, field)
            self.seconds |= field.task.clock.laps
        bound = result_objects.find_unlocked(obj)
        shown = lines.get(_PREVIEW) or (lines.get(bound.name) if bound else None)
        if shown:
            self.preview = Preview(shown.lines, shown.colors, next(_versions)) if obj.dirichlet.preview else None
        for result in result_objects.followers(obj):
            if result.name in lines:
                line_task.write(obj, lines[result.name], result)
        for outcome in lines.values():
            self.seconds |= {name: self.seconds.get(name, 0) + lap for name, lap in outcome.task.clock.laps.items()}
        self.seconds["total"] = perf_counter() - self.noted


def _read_lines(
    obj: bpy.types.Object, session: sessions.Session, depsgraph: bpy.types.Depsgraph | None
) -> dict[str, line_task.LineTask]:
    """Of the results that follow, and of the preview: what the bound result shows, if that follows too."""
    drawn: dict[str, bpy.types.Object | None] = {found.name: found for found in result_objects.followers(obj)}
    if obj.dirichlet.preview and result_objects.find_unlocked(obj) not in drawn.values():
        drawn[_PREVIEW] = None
    return {name: line_task.read(obj, found, session=session, depsgraph=depsgraph) for name, found in drawn.items()}
