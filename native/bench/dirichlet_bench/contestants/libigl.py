# SPDX-License-Identifier: GPL-3.0-or-later
"""libigl: harmonic(), which assembles, orders, factors and solves in one call, with its cotangent weights; isolines().

Its isolines are loose segments.
"""

from collections.abc import Callable
from pathlib import Path

import igl
import numpy as np

from ..recorder import Memory, Recorder
from ..scene import Scene, prescribed
from .isoline_levels import Reals, segment_length, time_levels


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    faces = scene.faces.astype(np.int64)
    vertices, values = prescribed(scene.first)
    vertices = vertices.astype(np.int64)

    def solve(columns: Reals, stage: str) -> Callable[[int], None]:
        def once(_: int) -> None:
            with recorder.time(stage):
                igl.harmonic(scene.positions, faces, vertices, columns, 1)

        return once

    memory = Memory()
    igl.harmonic(scene.positions, faces, vertices, values[:, None], 1)
    recorder.state("memory", memory.peak())
    recorder.repeat(solve(values[:, None], "arrays to field"))
    recorder.repeat(solve(np.repeat(values[:, None], 16, axis=1), "16 columns, arrays to field"))

    def extract(levels: Reals) -> Callable[[], float]:
        points, segments, _ = igl.isolines(scene.positions, faces, scene.reference, levels)
        return lambda: segment_length(points, segments)

    time_levels(recorder, extract)
