# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of which parts may run in another thread while people go on looking around.

A work is a generator. It reads and writes Blender's data itself, in the main thread, and yields steps to be computed in
any thread; it is sent what came of them, or thrown what they raised. It writes after its last step, so one that is
closed before its end has changed nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from concurrent.futures import Future
from typing import Any, NamedTuple

import bpy

from .. import library
from ..language import say
from . import threads
from .mesh import meshes

Progress = Callable[[float], None]  # called with the part done, from 0 to 1


class Step(NamedTuple):
    name: str  # of the object that it is for
    part: float  # of the whole work that comes before it, from 0 to 1
    compute: Callable[[], Any]  # touches nothing of Blender's


Work = Generator[Step, Any, Any]


class Background:
    """A work whose steps another thread computes."""

    def __init__(self, work: Work) -> None:
        """Raises what the work raises before its first step."""
        self._work = work
        self._start(next(work))

    def poll(self) -> Any:
        """What the work returns at its end; None before. Raises what the work raises. For the main thread."""
        try:
            while self._job.done():
                self._start(_answer(self._work, self._job))
        except StopIteration as end:
            return end.value
        return None

    def stop(self) -> None:
        """Drops what is not written yet. A step that is being computed ends by itself, for nothing."""
        self._work.close()

    def _start(self, step: Step) -> None:
        self.step, self._job = step, threads.start(step.compute)


class Held:
    """A mesh object between steps, in which it may be renamed, edited, undone or removed."""

    def __init__(self, obj: bpy.types.Object) -> None:
        self.name = obj.name
        self._address = obj.as_pointer()
        self._arrays: meshes.Arrays | None = None

    def find(self) -> bpy.types.Object:
        """The object now. Raises InputError when it is gone, cannot be read now or is not what `keep` was told."""
        objects = bpy.data.objects
        obj = objects.get((self.name, None)) or next((o for o in objects if o.as_pointer() == self._address), None)
        if obj is None:
            raise library.load().InputError(
                say("object '{name}' was removed while it was being worked on", name=self.name)
            )
        meshes.require_mesh(obj)
        if self._arrays and not self._arrays.same(meshes.read_arrays(obj.data)):
            raise library.load().InputError(
                say("the mesh of object '{name}' changed while it was being worked on", name=self.name)
            )
        return obj

    def keep(self, arrays: meshes.Arrays) -> None:
        """These are the arrays that results will be for."""
        self._arrays = arrays


def run(work: Work, progress: Progress = lambda done: None) -> Any:
    """All of the work here and now; what it returns. Raises what it raises."""
    try:
        step = next(work)
        while True:
            progress(step.part)
            step = _answer(work, threads.run(step.compute))
    except StopIteration as end:
        return end.value


def _answer(work: Work, job: Future) -> Step:
    """The next step, once the one before is done."""
    error = job.exception()
    return work.throw(error) if error else work.send(job.result())
