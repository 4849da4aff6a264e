# SPDX-License-Identifier: GPL-3.0-or-later
"""pyamg: conjugate gradients preconditioned by smoothed aggregation, to a relative residual of 1e-8."""

from pathlib import Path

import numpy as np
import pyamg

from ..recorder import Memory, Recorder
from ..scene import Scene
from ..systems import reduce, whole

TOLERANCE = 1e-8


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    memory = Memory()
    upper, rhs = reduce(scene.stiffness, scene.first)
    matrix = whole(upper.T.tocsc())
    solution = scene.first.copy()

    def once(run: int) -> None:
        with recorder.time("cold solve"):
            with recorder.time("factor"):
                hierarchy = pyamg.smoothed_aggregation_solver(matrix, symmetry="symmetric", max_coarse=500)
            with recorder.time("solve"):
                free = hierarchy.solve(rhs, tol=TOLERANCE, accel="cg")
        if run == 0:
            solution[np.isnan(scene.first)] = free
            np.save(field, solution)

    recorder.repeat(once)
    recorder.state("memory", memory.peak())
