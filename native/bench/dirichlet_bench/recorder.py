# SPDX-License-Identifier: GPL-3.0-or-later
"""What a contestant measures of itself, in lines of JSON; peers/recorder.h is the same for C++."""

import json
import resource
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from paper_table import forget_peak_memory, peak_memory


def user_seconds() -> float:
    """Of the processor, in all threads."""
    return float(resource.getrusage(resource.RUSAGE_SELF).ru_utime)


class Memory:
    """The highest memory of the process since now, over what it held then, in MB."""

    def __init__(self) -> None:
        forget_peak_memory()
        self._before = peak_memory()  # forgotten, it is what is held now

    def peak(self) -> float:
        return float(peak_memory() - self._before)


class Recorder:
    """Prints every measurement as soon as it is known: a contestant that dies later has said the rest."""

    def __init__(self, runs: int, seconds: float) -> None:
        self._runs = runs
        self._seconds = seconds

    def repeat(self, measure: Callable[[int], None]) -> None:
        """Calls measure(i) for i = 0, 1, … up to the number of runs, or until this stage has used up its seconds."""
        start = time.perf_counter()
        for i in range(self._runs):
            if i and time.perf_counter() - start > self._seconds:
                break
            measure(i)

    @contextmanager
    def time(self, stage: str) -> Iterator[None]:
        """Seconds on the wall, and of the processor in all threads, as a run of that stage."""
        wall, user = time.perf_counter(), user_seconds()
        yield
        self.record(stage, time.perf_counter() - wall, user_seconds() - user)

    def record(self, stage: str, wall: float, user: float | None = None) -> None:
        self._say({"stage": stage, "wall": wall, "user": user})

    def state(self, fact: str, value: float | str) -> None:
        self._say({"fact": fact, "value": value})

    @staticmethod
    def _say(line: dict[str, float | str | None]) -> None:
        print(json.dumps(line), flush=True)
