# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene: a mesh, its matrix, its paintings and the strokes on top; a folder of NumPy files, which C++ reads too."""

from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
import scipy.sparse

from .meshes import Indices, Reals

STROKE_VALUE = 0.5


@dataclass(frozen=True)
class Scene:
    positions: Reals
    """(V, 3)"""
    faces: Indices
    """(F, 3)"""
    stiffness_offsets: Indices
    """of the graph Laplacian D − A, or of other weights: its lower triangle in compressed columns"""
    stiffness_rows: Indices
    stiffness_values: Reals
    first: Reals
    """(V,) the painting: values where painted, NaN where free"""
    second: Reals
    """(V,) another one of the same mesh"""
    stroke: Indices
    """(8, ·) vertices that each stroke paints on top of the first painting and the strokes before"""
    dab: Indices
    """(8, ·) the same, but small"""
    reference: Reals
    """(V,) the field of the first painting, as exact as it gets; empty where it is not solved"""

    @property
    def stiffness(self) -> scipy.sparse.csc_matrix:
        """(V, V), its lower triangle."""
        size = len(self.positions)
        arrays = (self.stiffness_values, self.stiffness_rows, self.stiffness_offsets)
        return scipy.sparse.csc_matrix(arrays, shape=(size, size))


def load(folder: Path) -> Scene:
    return Scene(*(np.load(folder / f"{field.name}.npy") for field in fields(Scene)))


def save(scene: Scene, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for field in fields(Scene):
        np.save(folder / f"{field.name}.npy", getattr(scene, field.name))


def prescribed(painting: Reals) -> tuple[Indices, Reals]:
    """Painted vertices (C,), ascending, and their values (C,)."""
    vertices = np.flatnonzero(np.isfinite(painting)).astype(np.int32)
    return vertices, painting[vertices]


def brush(scene: Scene, kind: str) -> Iterator[Reals]:
    """The paintings after each stroke ("stroke" or "dab") on top of the first one; each holds until the next."""
    painting = scene.first.copy()
    for vertices in getattr(scene, kind):
        painting[vertices] = STROKE_VALUE
        yield painting
