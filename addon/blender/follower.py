# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows one object: what is pending, computed and shown."""

from __future__ import annotations

from concurrent.futures import Future, wait
from enum import IntFlag
from itertools import count
from time import perf_counter
from typing import Any, NamedTuple

import bpy
import numpy as np
from numpy.typing import NDArray

from .. import library
from ..sentences import told
from . import field_task, pipeline, threads
from .held import Held
from .lines import line_task, result_objects
from .mesh import attributes
from .mesh.sessions import Session, open_session
from .paint import patches

_MOST_LEVELS = 2000  # that are drawn at every change
_PREVIEW = 0
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

    session: Session | None  # nothing where there is nothing to do
    field: field_task.FieldTask | None
    lines: dict[int, line_task.LineTask]  # by the address of the result; _PREVIEW: those shown alone
    values: NDArray[np.float32] | None  # (V,) for the lines, unless they are of the new field

    @property
    def aim(self) -> Change:
        """What of it must not be out of date, lest all of it is."""
        return Change.FIELD if self.field else Change.LINES

    def interrupt(self) -> None:
        """Ends `compute`, whose result nobody wants any more."""
        for task in (self.field, *self.lines.values()):
            if task:
                task.interrupt()

    def compute(self) -> tuple[field_task.FieldOutcome | None, dict[int, line_task.LineOutcome], str]:
        """Field, lines, and why some are missing: levels that cannot be had hold neither field nor other lines back."""
        field, lines, problem = self.field.compute() if self.field else None, {}, ""
        values = field.values if field else self.values
        for address, task in self.lines.items():
            try:
                lines[address] = task.compute(values, _MOST_LEVELS)
            except library.refusals() as error:
                problem = str(error)
        return field, lines, problem


class Follower:
    def __init__(self, obj: bpy.types.Object) -> None:
        self.held = Held(obj)
        self.pending = Change(0)
        self.resting = True  # nobody paints, as far as known
        self.noted = 0.0  # when the last change came
        self.job: Future | None = None
        self.preview: Preview | None = None
        self.seconds: dict[str, float] = {}
        self._work: _Work | None = None  # what the job computes; nothing when it could not be read
        self._unwatched = False  # others may have changed the object since it was read
        self._begun = 0.0
        self.postponed = Change(0)  # until Edit Mode is left

    def note(self, what: Change, *, resting: bool) -> None:
        self.pending |= what
        self.noted = perf_counter()
        if Change.FIELD in what:
            self.resting = resting
        if self._work and self._work.aim in what and self.is_computing():
            self._work.interrupt()  # something newer is there

    def wait(self, seconds: float) -> None:
        """For a thread just begun, which is so quick as a rule that the change and what follows it are drawn together:
        then nobody else has touched the object since it was read."""
        if self.job:
            wait([self.job], timeout=seconds)
            self._unwatched = not self.job.done()

    def is_computing(self) -> bool:
        return self.job is not None and not self.job.done()

    def due(self) -> Change:
        """What can be done now: paint is not read under a moving brush, lines and colours need not wait."""
        return self.pending if self.resting else self.pending & ~Change.FIELD

    def has_something_to_do(self) -> bool:
        return not self.is_computing() and (self.job is not None or bool(self.due()))

    def resume(self, obj: bpy.types.Object) -> None:
        """What had to wait for the end of Edit Mode is due, if it has come."""
        if self.postponed and obj.mode != "EDIT":
            self.pending, self.postponed = self.pending | self.postponed, Change(0)

    def begin(self, obj: bpy.types.Object, *, thread: bool, depsgraph: bpy.types.Depsgraph | None = None) -> None:
        """Starts on what is due, unless something is being computed: in a thread, or here. depsgraph: a handler's."""
        what = self.due()
        if self.job or not what:
            return
        self.pending &= ~what
        if obj.mode == "EDIT":
            self.postponed = Change.COLORS & (self.postponed | what)  # for the rest, leaving it is a change again
            return
        self.held.keep(None)
        self._begun, self._work, self._unwatched = perf_counter(), None, thread
        try:
            self._work = self._read(obj, what, depsgraph)
            self.job = (threads.start if thread else threads.run)(self._work.compute)
        except library.refusals() as error:
            self.job = Future()
            self.job.set_exception(error)

    def finish(self, obj: bpy.types.Object, still: Change, note: str) -> None:
        """Writes what has been computed, waited for, unless it is out of date. still: what of the object follows; note:
        why not all of it does."""
        if not self.job:
            return
        job, work, self.job, self._work = self.job, self._work, None, None  # which would keep a forgotten session
        aim = work.aim if work else Change.LINES
        if self.pending & aim or aim not in still or not self._fits(obj):
            return
        problem = ""
        try:
            field, lines, problem = job.result()
            if problem:
                problem, self.preview = told(problem), None
            self._write(obj, field, lines)
        except library.refusals() as error:
            problem, self.preview = told(error), None
        if obj.dirichlet.results.problem != (problem or note):
            obj.dirichlet.results.problem = problem or note

    def _fits(self, obj: bpy.types.Object) -> bool:
        """Whether the object is what was read, where it may have been edited meanwhile."""
        return self.held.fits(obj) if self._unwatched else obj.mode != "EDIT"

    def _read(self, obj: bpy.types.Object, what: Change, depsgraph: bpy.types.Depsgraph | None) -> _Work:
        field = field_task.read(obj, depsgraph=depsgraph) if Change.FIELD in what else None
        if not field and not attributes.has_field(obj.data):
            self.preview = None
            return _Work(None, None, {}, None)
        if Change.COLORS in what and not field:
            pipeline.recolor(obj)
        if not what & (Change.FIELD | Change.LINES):
            return _Work(None, None, {}, None)
        session = field.session if field else open_session(obj)
        self.held.keep(session.arrays)
        lines = _read_lines(obj, session, depsgraph)
        return _Work(session, field, lines, line_task.read_values(obj) if lines and not field else None)

    def _write(self, obj: bpy.types.Object, field, lines: dict[int, line_task.LineOutcome]) -> None:
        self.seconds = {"wait": self._begun - self.noted}
        if field:
            if len(obj.data.vertices) <= patches.QUICK:
                painted = field.task.patches
                patches.record_facts(obj, painted, patches.inspect(field.task.session.mesh, painted))
            field_task.write(obj, field, cover=False)
            self.seconds |= field.task.clock.laps
        bound = result_objects.find_unlocked(obj)
        shown = lines.get(_PREVIEW) or (lines.get(bound.as_pointer()) if bound else None)
        if shown:
            self.preview = Preview(shown.lines, shown.colors, next(_versions)) if obj.dirichlet.preview else None
        for result in result_objects.followers(obj):
            if result.as_pointer() in lines:
                line_task.write(obj, lines[result.as_pointer()], result)
        for outcome in lines.values():
            self.seconds |= {name: self.seconds.get(name, 0) + lap for name, lap in outcome.task.clock.laps.items()}
        self.seconds["total"] = perf_counter() - self.noted


def _read_lines(
    obj: bpy.types.Object, session: Session, depsgraph: bpy.types.Depsgraph | None
) -> dict[int, line_task.LineTask]:
    """Of the results that follow, and of the preview: what the bound result shows, if that follows too."""
    followers = result_objects.followers(obj)
    drawn: dict[int, bpy.types.Object | None] = {found.as_pointer(): found for found in followers}
    if obj.dirichlet.preview and result_objects.find_unlocked(obj) not in drawn.values():
        drawn[_PREVIEW] = None
    return {key: line_task.read(obj, found, session=session, depsgraph=depsgraph) for key, found in drawn.items()}
