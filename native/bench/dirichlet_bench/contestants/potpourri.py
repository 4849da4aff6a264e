# SPDX-License-Identifier: GPL-3.0-or-later
"""potpourri3d (geometry-central): marching triangles, a level at a time; its mesh is made beforehand."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import potpourri3d
from numpy.typing import NDArray

from ..recorder import Recorder
from ..scene import Scene
from .isoline_levels import Reals, time_levels


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    solver = potpourri3d.MeshMarchingTrianglesSolver(scene.positions, scene.faces)
    ends = potpourri3d.edges(scene.positions, scene.faces)

    def extract(levels: Reals) -> Callable[[], float]:
        curves = [solver.marching_triangles(scene.reference, level) for level in levels]
        return lambda: sum(length(curve, scene.positions, ends) for level in curves for curve in level)

    time_levels(recorder, extract, (13,))  # 100 levels take 100 / 13 of that


def length(curve: Sequence[tuple[int, list[float]]], positions: Reals, ends: NDArray[np.integer]) -> float:
    """Of points on edges, each an edge and a place on it."""
    edges = ends[[edge for edge, _ in curve]]
    place = np.array([place for _, (place,) in curve])[:, None]
    points = positions[edges[:, 0]] * (1 - place) + positions[edges[:, 1]] * place
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
