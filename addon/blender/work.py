# SPDX-License-Identifier: GPL-3.0-or-later
"""Work of which parts may run in another thread while people go on looking around.

A work is a generator. It reads and writes Blender's data itself, in the main thread, and yields steps to be computed in
any thread; it is sent what came of them, or thrown what they raised. It writes after its last step, so one that is
closed before its end has changed nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from concurrent.futures import Future, wait
from contextlib import contextmanager
from time import perf_counter
from typing import Any, NamedTuple

from . import threads

Progress = Callable[[float], None]  # called with the part done, from 0 to 1


class Step(NamedTuple):
    name: str  # of the object that it is for
    part: float  # of the whole work that comes before it, from 0 to 1
    compute: Callable[[], Any]  # touches nothing of Blender's
    doing: str = ""  # what it does, where the work has other steps too


Work = Generator[Step, Any, Any]


class Made(NamedTuple):
    """What was made, to be reported."""

    results: list  # FieldResult or IsolineResult, one per object
    summary: str  # or nothing, where people see it anyway
    warnings: tuple[str, ...] = ()


@contextmanager
def stopping(stop: Callable[[], None]) -> Iterator[None]:
    """Around a `yield` of a work: if that is closed meanwhile, `stop` ends what nobody waits for any more."""
    try:
        yield
    except GeneratorExit:
        stop()
        raise


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

    def wait(self, seconds: float) -> Any:
        """What `poll` returns once the work is done, or after so many seconds."""
        end = perf_counter() + seconds
        while (made := self.poll()) is None and perf_counter() < end:
            wait([self._job], timeout=max(0.0, end - perf_counter()))
        return made

    def stop(self) -> None:
        """Drops what is not written yet. The work stops the step that is being computed, or lets it end by itself."""
        self._work.close()

    def _start(self, step: Step) -> None:
        self.step, self._job = step, threads.start(step.compute)


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
