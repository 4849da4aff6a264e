# SPDX-License-Identifier: GPL-3.0-or-later
"""Intel PARDISO for symmetric positive definite matrices."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from pypardiso.pardiso_wrapper import PyPardisoSolver

from ..recorder import Memory, Recorder
from ..scene import Scene, brush
from ..systems import Reals, inject, reduce

POSITIVE_DEFINITE = 2
ANALYSE, FACTOR, SOLVE = 11, 22, 33


class Pardiso:
    """The library's own three phases, without the wrapper's checks and copies between them."""

    def __init__(self) -> None:
        self._solver = PyPardisoSolver(mtype=POSITIVE_DEFINITE)

    def phase(self, phase: int, upper: Any, rhs: Reals) -> Reals:
        self._solver.set_phase(phase)
        return np.asarray(self._solver._call_pardiso(upper, rhs))

    def free(self) -> None:
        self._solver.free_memory(everything=True)


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    live(scene, field, recorder)
    cold(scene, recorder)


def cold(scene: Scene, recorder: Recorder) -> None:
    """Order, factor and solve the smallest system, from nothing."""
    upper, rhs = reduce(scene.stiffness, scene.first)

    def once(_: int) -> None:
        pardiso = Pardiso()
        with recorder.time("cold solve"):
            for stage, phase in (("order", ANALYSE), ("factor", FACTOR), ("solve", SOLVE)):
                with recorder.time(stage):
                    pardiso.phase(phase, upper, rhs)
        pardiso.free()

    recorder.repeat(once)


def live(scene: Scene, field: Path, recorder: Recorder) -> None:
    """One analysis for every painting of the mesh."""
    pardiso = Pardiso()
    memory = Memory()  # the painted matrix counts, as the one that ours makes itself
    paintings = [inject(scene.stiffness, scene.first)]
    for phase in (ANALYSE, FACTOR):
        pardiso.phase(phase, *paintings[0])
    np.save(field, pardiso.phase(SOLVE, *paintings[0]).ravel())
    recorder.state("memory", memory.peak())
    paintings.append(inject(scene.stiffness, scene.second))

    def repaint(run: int) -> None:
        with recorder.time("later"):
            for stage, phase in (("later factor", FACTOR), ("values", SOLVE)):
                with recorder.time(stage):
                    pardiso.phase(phase, *paintings[(run + 1) % 2])

    recorder.repeat(repaint)
    for kind in ("stroke", "dab"):
        strokes = (inject(scene.stiffness, painting) for painting in brush(scene, kind))
        recorder.repeat(stroker(pardiso, strokes, kind, recorder))
    matrix, rhs = paintings[0]
    pardiso.phase(FACTOR, matrix, rhs)
    columns = np.asfortranarray(np.repeat(rhs[:, None], 16, axis=1))

    def solve_columns(_: int) -> None:
        with recorder.time("16 columns"):
            pardiso.phase(SOLVE, matrix, columns)

    recorder.repeat(solve_columns)
    pardiso.free()


def stroker(
    pardiso: Pardiso, strokes: Iterator[tuple[Any, Reals]], kind: str, recorder: Recorder
) -> Callable[[int], None]:
    def stroke(_: int) -> None:
        system = next(strokes, None)
        if system is None:
            return
        with recorder.time(kind):
            for phase in (FACTOR, SOLVE):
                pardiso.phase(phase, *system)

    return stroke
