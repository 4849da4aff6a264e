# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps that run inside a Blender with a window, which goes on drawing and handling events between them.

A step is a generator function. It yields the seconds to leave to Blender before it goes on, and is named by its name:
in the log, in the picture taken after it, and in the verdict that ../window.py reads in the log.
"""

import faulthandler
import os
import signal
import subprocess
import sys
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path
from time import perf_counter

import bpy

STEP, PASSED = "UI STEP", "UI PASSED"  # what the log's verdict is made of
_TICK = 0.03

Waiting = Iterator[float]
words = sys.argv[sys.argv.index("--") + 1 :]
pictures = Path(words.pop(0))


def run(*steps: Callable[[], Waiting]) -> None:
    """Plays the steps once Blender is up, and ends it: with exit code 0 when all of them passed."""
    faulthandler.register(signal.SIGUSR1)  # says where a Blender that hangs is
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.system.viewport_aa = "OFF"  # drawing is done by software
    bpy.context.preferences.inputs.use_mouse_continuous = False  # it takes the pointer elsewhere, the hand's pixels not
    waits = _play(steps)

    def tick() -> float | None:
        try:
            return next(waits, None)
        except Exception:
            traceback.print_exc()
            subprocess.run(_picture("failed"), check=False)
            sys.stdout.flush()
            os._exit(1)

    bpy.app.timers.register(tick, first_interval=1, persistent=True)


def until(condition: Callable[[], object], limit: float = 60) -> Waiting:
    """Waits until the condition holds, or fails after `limit` seconds."""
    end = perf_counter() + limit
    while not condition():
        assert perf_counter() < end, f"{condition.__name__} ({condition.__code__.co_firstlineno}) within {limit} s"
        yield _TICK


def finished(*command: object) -> Waiting:
    """Waits for a program of its own, which may work with Blender's window meanwhile."""
    process = subprocess.Popen([str(word) for word in command])
    yield from until(lambda: process.poll() is not None)
    assert process.returncode == 0, command


def picture(name: str) -> Waiting:
    """The whole screen as a file."""
    yield from finished(*_picture(name))


def _picture(name: str) -> list[str]:
    return ["import", "-window", "root", str(pictures / f"{name}.png")]


def _play(steps: tuple[Callable[[], Waiting], ...]) -> Waiting:
    for number, step in enumerate(steps, start=1):
        print(STEP, step.__name__, flush=True)
        yield from step()
        yield from picture(f"{number:02}-{step.__name__.replace('_', '-')}")
    print(PASSED, flush=True)
    bpy.ops.wm.quit_blender()
