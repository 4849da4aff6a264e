# SPDX-License-Identifier: GPL-3.0-or-later
"""Irregular triangle meshes of any size. The same seed gives the same mesh."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Indices = NDArray[np.int32]


class Triangles(NamedTuple):
    positions: Reals
    """(V, 3)"""
    faces: Indices
    """(F, 3)"""


class Sides(NamedTuple):
    """Edges of a triangle mesh, and those of each face: side k runs from corner k to the next."""

    ends: NDArray[np.int64]
    """(E, 2) smaller vertex first"""
    of_face: NDArray[np.int64]
    """(F, 3)"""


def sides_of(mesh: Triangles) -> Sides:
    pairs = np.stack([mesh.faces, np.roll(mesh.faces, -1, axis=1)], axis=2).reshape(-1, 2).astype(np.int64)
    pairs.sort(axis=1)
    count = len(mesh.positions)
    keys, edge = np.unique(pairs[:, 0] * count + pairs[:, 1], return_inverse=True)
    return Sides(np.column_stack([keys // count, keys % count]), edge.reshape(-1, 3))


def refine(mesh: Triangles, count: int, rng: np.random.Generator) -> Triangles:
    """Splits edges, about the longest first and about in their middle, until there are `count` vertices; flips even out
    how many edges meet at a vertex, until it is as irregular as a scan: mostly 5, 6 or 7. A mesh that has as many
    vertices stays as it is."""
    if len(mesh.positions) >= count:
        return mesh
    while len(mesh.positions) < count:
        mesh = flip_edges(split_long_edges(mesh, count - len(mesh.positions), rng), rng, evening=True)
    return flip_edges(flip_edges(mesh, rng), rng, evening=True)


def split_long_edges(mesh: Triangles, at_most: int, rng: np.random.Generator) -> Triangles:
    """Those that are the longest side of all their faces, so that each face is cut once at most; lengths are blurred,
    or the result would be as regular as its start."""
    sides = sides_of(mesh)
    first, second = mesh.positions[sides.ends[:, 0]], mesh.positions[sides.ends[:, 1]]
    length = np.linalg.norm(first - second, axis=1) * rng.uniform(0.7, 1.4, len(first))
    rows = np.arange(len(mesh.faces))
    longest = np.argmax(length[sides.of_face], axis=1)
    votes = np.bincount(sides.of_face[rows, longest], minlength=len(first))
    chosen = np.flatnonzero(votes == np.bincount(sides.of_face.ravel(), minlength=len(first)))
    chosen = chosen[np.argsort(-length[chosen], kind="stable")[:at_most]]
    place = rng.uniform(0.35, 0.65, (len(chosen), 1))
    middle = np.full(len(first), -1)
    middle[chosen] = len(mesh.positions) + np.arange(len(chosen))
    cut = middle[sides.of_face[rows, longest]]
    a, b, c = (mesh.faces[rows, (longest + k) % 3] for k in range(3))  # the longest side runs from a to b
    halves = (np.stack([a, cut, c], axis=1)[cut >= 0], np.stack([cut, b, c], axis=1)[cut >= 0])
    return Triangles(
        np.concatenate([mesh.positions, first[chosen] * place + second[chosen] * (1 - place)]),
        np.concatenate([mesh.faces[cut < 0], *halves]).astype(np.int32),
    )


def flip_edges(mesh: Triangles, rng: np.random.Generator, evening: bool = False) -> Triangles:
    """Random ones without a vertex in common, where neither the surface folds nor an edge comes twice; if `evening`,
    only from vertices of many edges to those of few."""
    sides = sides_of(mesh)
    order = np.argsort(sides.of_face.ravel(), kind="stable")
    uses = np.bincount(sides.of_face.ravel(), minlength=len(sides.ends))
    start = (np.cumsum(uses) - uses)[uses == 2]
    left, right = order[start], order[start + 1]  # corners at whose sides two faces meet
    turned = np.roll(mesh.faces, -1, axis=1).ravel(), np.roll(mesh.faces, -2, axis=1).ravel()
    a, b, c, d = mesh.faces.ravel()[left], turned[0][left], turned[1][left], turned[1][right]
    quads = np.stack([a, b, c, d], axis=1)  # a b c and b a d become a d c and d b c
    new = np.sort(np.stack([c, d], axis=1).astype(np.int64), axis=1)
    keys = sides.ends[:, 0] * len(mesh.positions) + sides.ends[:, 1]
    legal = (mesh.faces.ravel()[right] == b) & ~np.isin(new[:, 0] * len(mesh.positions) + new[:, 1], keys)
    if evening:
        degree = np.bincount(sides.ends.ravel())
        legal &= degree[a] + degree[b] > degree[c] + degree[d] + 2
    old_normal = normals(mesh.positions, a, b, c) + normals(mesh.positions, b, a, d)
    for after in (normals(mesh.positions, a, d, c), normals(mesh.positions, d, b, c)):
        legal &= np.einsum("ij,ij->i", after, old_normal) > 0.1 * np.einsum("ij,ij->i", old_normal, old_normal)
    rank = rng.permutation(len(quads))
    rank[~legal] = len(quads)
    lowest = np.full(len(mesh.positions), len(quads))
    np.minimum.at(lowest, quads.ravel(), np.repeat(rank, 4))
    chosen = legal & (lowest[quads] == rank[:, None]).all(axis=1)
    faces = mesh.faces.copy()
    faces[left[chosen] // 3] = np.stack([a, d, c], axis=1)[chosen]
    faces[right[chosen] // 3] = np.stack([d, b, c], axis=1)[chosen]
    return Triangles(mesh.positions, faces)


def normals(positions: Reals, a: Indices, b: Indices, c: Indices) -> Reals:
    """Twice the area long."""
    return np.asarray(np.cross(positions[b] - positions[a], positions[c] - positions[a]))


def shuffle(mesh: Triangles, rng: np.random.Generator) -> Triangles:
    """The same surface, vertices and faces in random order."""
    place = rng.permutation(len(mesh.positions))
    positions = np.empty_like(mesh.positions)
    positions[place] = mesh.positions
    return Triangles(positions, rng.permutation(place[mesh.faces].astype(np.int32)))


def tube(count: int, around: int, rng: np.random.Generator) -> Triangles:
    """About `count` vertices, open at both ends, much longer than wide; diagonals at random."""
    rings = count // around
    ring, place = (grid.ravel() for grid in np.meshgrid(np.arange(rings), np.arange(around), indexing="ij"))
    angle = 2 * np.pi / around * (place + rng.uniform(-0.3, 0.3, len(place)))
    along = 2 * np.pi / around * (ring + rng.uniform(-0.3, 0.3, len(place)))
    a = (ring * around + place)[:-around]
    b = a - place[:-around] + (place[:-around] + 1) % around
    c, d = b + around, a + around
    one_way = (rng.random(len(a)) < 0.5)[:, None]
    first = np.where(one_way, np.stack([a, b, c], axis=1), np.stack([a, b, d], axis=1))
    second = np.where(one_way, np.stack([a, c, d], axis=1), np.stack([b, c, d], axis=1))
    faces = np.concatenate([first, second]).astype(np.int32)
    return Triangles(np.column_stack([along, np.cos(angle), np.sin(angle)]), faces)


def ball(count: int, rng: np.random.Generator) -> Triangles:
    """An octahedron, refined and blown up."""
    corners = np.concatenate([np.eye(3), -np.eye(3)])
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    mesh = refine(Triangles(corners, np.array(faces, np.int32)), count, rng)
    return Triangles(mesh.positions / np.linalg.norm(mesh.positions, axis=1)[:, None], mesh.faces)


def copies(mesh: Triangles, count: int) -> Triangles:
    """In a row, numbered one after the other."""
    step = np.ptp(mesh.positions[:, 0]) * 1.1
    shifts = np.arange(count)[:, None, None]
    positions = mesh.positions + shifts * np.array([step, 0.0, 0.0])
    return Triangles(
        positions.reshape(-1, 3), (mesh.faces + shifts * len(mesh.positions)).reshape(-1, 3).astype(np.int32)
    )


def read_base(path: Path) -> Triangles:
    """The surface that is refined: of that file, or a torus where there is none."""
    import dirichlet_surface as surface

    if path.is_file():
        mesh = surface.read_mesh(path)
        return Triangles(np.array(mesh.positions), np.array(mesh.triangles, np.int32))
    u, v = (2 * np.pi * grid.ravel() for grid in np.meshgrid(np.arange(140) / 140, np.arange(100) / 100, indexing="ij"))
    radius = 2 + np.cos(v) * (1 + 0.3 * np.sin(5 * u))
    i, j = np.divmod(np.arange(14000), 100)
    right, up, both = (((i + di) % 140) * 100 + (j + dj) % 100 for di, dj in ((1, 0), (0, 1), (1, 1)))
    here = np.arange(14000)
    faces = np.concatenate([np.stack([here, right, both], axis=1), np.stack([here, both, up], axis=1)])
    return Triangles(np.stack([radius * np.cos(u), radius * np.sin(u), np.sin(v)], axis=1), faces.astype(np.int32))
