# SPDX-License-Identifier: GPL-3.0-or-later
"""One mesh with one Laplacian and one painting: what has to be true of field and isolines, and what came of it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import isoline_laws
import numpy as np
from dirichlet_surface import (
    DirichletError,
    Mesh,
    Patch,
    combine_patches,
    even_levels,
    geodesic_disc,
    isolines,
    read_mesh,
    solve,
)

#: Those that promise no more than to say how far outside the painted range a field went.
WITHOUT_A_MAXIMUM_PRINCIPLE = {"cotangent", "polygon"}


class Case(NamedTuple):
    path: Path
    laplacian: str
    painting: str


@dataclass
class Outcome:
    status: str
    """passed, refused or failed"""
    why: str = ""
    vertices: int = 0
    faces: int = 0
    outside: int = 0
    """values outside the painted range of their piece"""
    farthest: float = 0.0
    """how far, as a share of the painted range"""
    open_ends: int = 0
    """of isolines, away from where a line may end"""
    seconds: float = 0.0
    """of solver and isolines"""


def lowest_and_highest(mesh: Mesh, random: np.random.Generator) -> Iterator[tuple[np.ndarray, float]]:
    """A hundredth of the vertices each, along the longest side of the bounding box."""
    along = mesh.positions[:, np.argmax(np.ptp(mesh.positions, axis=0))]
    order = np.argsort(along, kind="stable")
    count = max(1, len(order) // 100)
    yield order[:count], 0.0
    yield order[-count:], 1.0


def eight_vertices(mesh: Mesh, random: np.random.Generator) -> Iterator[tuple[np.ndarray, float]]:
    for place, vertex in enumerate(random.permutation(mesh.vertex_count)[:8]):
        yield np.array([vertex]), place % 2


def five_discs(mesh: Mesh, random: np.random.Generator) -> Iterator[tuple[np.ndarray, float]]:
    """Geodesic discs around vertices of faces, of a twentieth of the bounding box's diagonal."""
    radius = 0.05 * np.linalg.norm(np.ptp(mesh.positions, axis=0))
    for corner in random.integers(len(mesh.corners), size=5):
        vertex = mesh.corners[corner]
        disc, _ = geodesic_disc(mesh, mesh.positions[vertex], radius)
        yield np.union1d(disc, [vertex]), random.uniform(-1, 1)


PAINTINGS: dict[str, Callable[[Mesh, np.random.Generator], Iterable[tuple[np.ndarray, float]]]] = {
    "lowest and highest": lowest_and_highest,
    "eight vertices": eight_vertices,
    "five discs": five_discs,
}


@lru_cache(maxsize=1)
def mesh_of(path: Path) -> Mesh:
    return read_mesh(path)


def check(case: Case) -> Outcome:
    outcome = Outcome("passed")
    try:
        mesh = mesh_of(case.path)
        outcome.vertices, outcome.faces = mesh.vertex_count, mesh.face_count
        examine(mesh, case, outcome)
    except DirichletError as error:
        outcome.status, outcome.why = "refused", str(error)
    except AssertionError as error:
        outcome.status, outcome.why = "failed", " ".join(str(error).split())
    except Exception as error:
        outcome.status, outcome.why = "failed", f"{type(error).__name__}: {error}"
    return outcome


def examine(mesh: Mesh, case: Case, outcome: Outcome) -> None:
    patches = PAINTINGS[case.painting](mesh, np.random.default_rng(0))
    named = [Patch(str(number), vertices, value) for number, (vertices, value) in enumerate(patches)]
    painting = combine_patches(named, mesh.vertex_count, overlap="first")
    start = time.perf_counter()
    field = solve(mesh, painting.vertices, painting.values, laplacian=case.laplacian).values
    outcome.seconds = time.perf_counter() - start
    assert (field[painting.vertices] == painting.values).all(), "a painted vertex has another value"
    examine_range(mesh, painting.vertices, painting.values, field, outcome)
    if case.laplacian not in WITHOUT_A_MAXIMUM_PRINCIPLE:
        assert outcome.outside == 0, f"{outcome.outside} values lie outside the painted range"

    low, high = np.nanmin(field), np.nanmax(field)
    levels = even_levels(low, high, 10) if low < high else np.empty(0)
    lines = isolines(mesh, field, levels)
    outcome.seconds += lines.seconds
    outcome.open_ends = len(isoline_laws.ends_in_the_open(mesh, field, lines))
    isoline_laws.assert_sound(mesh, field, lines)


def examine_range(mesh: Mesh, vertices: np.ndarray, values: np.ndarray, field: np.ndarray, outcome: Outcome) -> None:
    """Piece by piece; a piece without paint has no values."""
    piece, count = mesh.components()
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, piece[vertices], values)
    np.maximum.at(high, piece[vertices], values)
    painted = (low <= high)[piece]
    undefined = ~np.isfinite(field)
    assert not (undefined & painted).any(), f"vertex {np.argmax(undefined & painted)} of a painted piece has no value"
    assert not (~undefined & ~painted).any(), f"vertex {np.argmax(~undefined & ~painted)} has a value without paint"
    beyond = np.maximum(low[piece] - field, field - high[piece])[painted]
    outcome.outside = int(np.count_nonzero(beyond > 0))
    outcome.farthest = max(0.0, float(beyond.max())) / (np.ptp(values) or 1.0)
