# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases one after another in a process beside this one, which may crash or hang without taking the others along."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection
from typing import TypeVar

C = TypeVar("C")
R = TypeVar("R")


class NoResultError(Exception):
    """A case that has no result; the message says why."""


def results(
    check: Callable[[C], R], cases: Sequence[C], limit: Callable[[C], float], start: float = 60
) -> Iterator[R | NoResultError]:
    """check(case) for each of them, or why there is none.

    limit  seconds for a case
    start  seconds more for the first in a process
    """
    rest = list(cases)
    while rest:
        here, there = multiprocessing.get_context("spawn").Pipe(duplex=False)
        process = multiprocessing.get_context("spawn").Process(target=work, args=(check, rest, there))
        process.start()
        there.close()
        try:
            extra = start
            while rest:
                result = receive(here, process, limit(rest.pop(0)) + extra)
                extra = 0
                yield result
        except NoResultError as none:
            yield none
        finally:
            process.kill()
            process.join()
            here.close()


def work(check: Callable[[C], R], cases: Sequence[C], there: Connection) -> None:
    for case in cases:
        there.send(check(case))


def receive(here: Connection, process: multiprocessing.process.BaseProcess, seconds: float) -> R:
    if not here.poll(seconds):
        raise NoResultError(f"no result within {seconds:.0f} s")
    try:
        return here.recv()
    except EOFError:
        process.join()
        code = process.exitcode or 0
        raise NoResultError(f"crashed: {signal.Signals(-code).name if code < 0 else f'exit code {code}'}") from None
