# SPDX-License-Identifier: GPL-3.0-or-later
"""dirichlet_surface: connectivity and isolines."""

from collections.abc import Callable
from pathlib import Path

import dirichlet_surface as surface

from ..recorder import Recorder
from ..scene import Scene
from .isoline_levels import Reals, time_levels


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    def connect(_: int) -> None:
        with recorder.time("connectivity"):
            surface.Mesh(scene.positions, scene.faces)

    recorder.repeat(connect)
    if not scene.reference.size:
        return
    mesh = surface.Mesh(scene.positions, scene.faces)

    def extract(levels: Reals) -> Callable[[], float]:
        lines = surface.isolines(mesh, scene.reference, levels)
        return lambda: float(lines.length.sum())

    time_levels(recorder, extract)
