# SPDX-License-Identifier: GPL-3.0-or-later
"""Computing beside the interface."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, wait
from threading import Thread
from typing import Any

_running: set[Future] = set()


def start(compute: Callable[[], Any]) -> Future:
    """What comes of it, computed in a thread of its own; it touches nothing of Blender's."""
    job: Future = Future()
    _running.add(job)
    job.add_done_callback(_running.discard)
    # A daemon, since Blender waits for other threads before it quits, and computing may take very long.
    Thread(target=_fulfil, args=(job, compute), name="Dirichlet", daemon=True).start()
    return job


def run(compute: Callable[[], Any]) -> Future:
    """The same here and now."""
    job: Future = Future()
    _fulfil(job, compute)
    return job


def settle(seconds: float) -> None:
    """Gives what was told to stop the time to do so: a thread that outlives Python would take Blender down."""
    wait(set(_running), timeout=seconds)


def _fulfil(job: Future, compute: Callable[[], Any]) -> None:
    try:
        job.set_result(compute())
    except Exception as error:  # for whoever asks for the result
        job.set_exception(error)
