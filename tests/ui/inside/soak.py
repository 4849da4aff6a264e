# SPDX-License-Identifier: GPL-3.0-or-later
"""Random use with Live on, in one Blender process: soak [--minutes M] [--seed S].

When it rests, the stored field has to be a new solve's, bit for bit, its colours those of the ramp and its lines new
ones of that field. After --minutes long enough to tell, the process
must not have grown. What went wrong in the log (a traceback) or with the process (a crash) is seen from outside.
"""

import argparse
import random
from pathlib import Path
from time import perf_counter

import actions
import numpy as np
from canvas import ball, go_to
from dirichlet_isolines import dirichlet_surface
from dirichlet_isolines.blender import live
from steps import Waiting, run, until, words
from truth import colors_follow, is_fresh, lines_follow

_WARM_UP = 0.25  # the part of the time after which memory counts
_TELLING = 300  # seconds from which growth can be told from noise
_GROWTH = 1.10

parser = argparse.ArgumentParser(prog="soak")
parser.add_argument("--minutes", type=float, default=1 / 3)
parser.add_argument("--seed", type=int, default=1)
options = parser.parse_args(words)
chance = random.Random(options.seed)
resident: list[tuple[float, float]] = []  # seconds since the start, megabytes


def use_at_random() -> Waiting:
    yield from actions.prepare()
    start, end, count = perf_counter(), perf_counter() + 60 * options.minutes, 0
    while perf_counter() < end:
        for _ in range(chance.randint(3, 12)):
            action = chance.choices(*zip(*actions.WEIGHTS.items()))[0]
            count += 1
            print(f"{perf_counter() - start:8.2f} s  {action.__name__}", flush=True)
            yield from action(chance)
            yield chance.choice((0, 0, 0.05, 0.3))
        yield from _rest()
        resident.append((perf_counter() - start, _resident_megabytes()))
        print(f"{resident[-1][0]:8.2f} s  rests after {count} actions, {resident[-1][1]:.1f} MB", flush=True)


def memory_is_flat() -> Waiting:
    yield 0
    seconds, megabytes = np.array(resident).T
    warm = megabytes[seconds >= _WARM_UP * seconds[-1]]
    early, late = (np.median(part) for part in np.array_split(warm, 3)[::2])
    print(f"memory after warm-up {early:.1f} MB, at the end {late:.1f} MB, highest {megabytes.max():.1f} MB")
    assert seconds[-1] < _TELLING or late < _GROWTH * early


def _rest() -> Waiting:
    """Until everything has been followed."""
    go_to("OBJECT")
    if not ball().dirichlet.live:  # set again, all would be computed again, and whatever was left out with it
        ball().dirichlet.live = True
    yield from until(_is_settled)


def _is_settled() -> bool:
    if live.is_pending(ball()):
        return False
    try:
        return is_fresh(ball()) and colors_follow(ball()) and lines_follow(ball(), live.preview_of(ball()))
    except dirichlet_surface.DirichletError:  # there is no field of such paint
        return True


def _resident_megabytes() -> float:
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 1e6


run(use_at_random, memory_is_flat)
