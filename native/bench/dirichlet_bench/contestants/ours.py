# SPDX-License-Identifier: GPL-3.0-or-later
"""dirichlet_surface, through its NumPy arrays."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import dirichlet_surface as surface
import numpy as np

from ..recorder import Memory, Recorder
from ..scene import Scene, brush, prescribed

VARIANTS: dict[str, dict[str, Any]] = {
    "": {},
    "float32": {"precision": "float32"},
    "multigrid": {"method": "multigrid"},
}
FACTOR_STAGES = ("injection", "factorisation")


def run(scene: Scene, field: Path, recorder: Recorder, variant: str = "") -> None:
    options = VARIANTS[variant]
    live(scene, field, recorder, options)
    solver = cold(scene, recorder, options)
    if variant != "multigrid":  # which takes one column after the other: minutes
        columns(solver, scene, recorder)


def cold(scene: Scene, recorder: Recorder, options: dict[str, Any]) -> Any:
    """Arrays in, field out; and the part of it that is order, factor and solve. Returns the last solver."""
    vertices, values = prescribed(scene.first)
    solvers: list[Any] = []

    def once(_: int) -> None:
        solvers.clear()  # not two in memory
        with recorder.time("arrays to field"):
            solver = surface.HarmonicSolver(surface.Mesh(scene.positions, scene.faces), vertices, **options)
            solver.solve(values)
        seconds = {stage: took for stage, took in solver.report.seconds.items() if stage != "connectivity"}
        for stage, took in seconds.items():
            recorder.record(stage, took)
        recorder.record("cold solve", sum(seconds.values()) - seconds["laplacian"])
        solvers.append(solver)

    recorder.repeat(once)
    return solvers[0]


def columns(solver: Any, scene: Scene, recorder: Recorder) -> None:
    values = np.repeat(prescribed(scene.first)[1][:, None], 16, axis=1)

    def once(_: int) -> None:
        with recorder.time("16 columns"):
            solver.solve(values)

    recorder.repeat(once)


def live(scene: Scene, field: Path, recorder: Recorder, options: dict[str, Any]) -> None:
    """One solver for all paintings of the mesh."""
    vertices, values = prescribed(scene.first)
    mesh = surface.Mesh(scene.positions, scene.faces)
    memory = Memory()
    solver = surface.HarmonicSolver(mesh, vertices, **options)
    np.save(field, solver.solve(values))
    recorder.state("memory", memory.peak())
    recorder.state("own residual", solver.report.relative_residual)
    paint(solver, scene, recorder, memory)

    def solve_values(run: int) -> None:
        with recorder.time("values"):
            solver.solve(values + 0.01 * run)

    recorder.repeat(solve_values)


def paint(solver: Any, scene: Scene, recorder: Recorder, memory: Memory) -> None:
    """Strokes, dabs and whole paintings; what the solver did about them becomes facts. Ends with the first painting."""
    paintings = [prescribed(painting) for painting in (scene.second, scene.first)]

    def repaint(run: int) -> None:
        with recorder.time("later"):
            solver.paint(*paintings[run % 2])
        recorder.record("later factor", sum(solver.report.seconds[stage] for stage in FACTOR_STAGES))
        say_update(solver, "later", recorder)

    for kind in ("stroke", "dab"):
        solver.paint(*paintings[1])
        recorder.repeat(stroker(solver, [prescribed(painting) for painting in brush(scene, kind)], kind, recorder))
    recorder.state("memory with strokes", memory.peak())
    recorder.repeat(repaint)
    solver.paint(*paintings[1])


def stroker(solver: Any, paintings: list[Any], kind: str, recorder: Recorder) -> Callable[[int], None]:
    def stroke(run: int) -> None:
        if run >= len(paintings):
            return
        with recorder.time(kind):
            solver.paint(*paintings[run])
        say_update(solver, kind, recorder)

    return stroke


def say_update(solver: Any, kind: str, recorder: Recorder) -> None:
    recorder.state(f"{kind} update", solver.report.update)
    recorder.state(f"{kind} repeated", solver.report.repeated)
