# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the scenes of the benchmark, once: python -m dirichlet_bench.scene_maker NAME BASE STORE PEERS."""

import hashlib
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import dirichlet_surface as surface
import numpy as np
import scipy.sparse
from painting_discs import far_apart_discs, grow_disc, neighbours

from . import meshes
from .meshes import Indices, Reals, Triangles
from .scene import Scene, save

STROKES = 8
STROKE_SHARE = 0.001
DAB = 30
SEED = 20
REFERENCE_LIMIT = 5_000_000
"""vertices, beyond which the field is not solved beforehand: its factor alone would fill the memory"""


def folder_of(name: str, base: Path, store: Path) -> Path:
    """Where the scene is, once it was made by this code from this base."""
    mark = hashlib.sha256(base.read_bytes() if base.is_file() else b"torus")
    for source in (meshes.__file__, __file__):
        mark.update(Path(source).read_bytes())
    return store / f"{name.replace(' ', '-')}-{mark.hexdigest()[:8]}"


def main(name: str, base: Path, store: Path, peers: Path) -> None:
    """`peers` solves the field."""
    folder = folder_of(name, base, store)
    for outdated in store.glob(f"{folder.name[:-8]}{'?' * 8}"):
        shutil.rmtree(outdated)
    unfinished = folder.with_name("unfinished")
    save(make(name, meshes.read_base(base)), unfinished)
    if vertex_count(name) <= REFERENCE_LIMIT:
        subprocess.run([peers, "reference", unfinished, unfinished / "reference.npy", "1", "0"], check=True)
    unfinished.rename(folder)


def vertex_count(name: str) -> int:
    size = name.split()[0]
    return {"k": 1_000, "M": 1_000_000}[size[-1]] * int(size[:-1])


def make(name: str, base: Triangles) -> Scene:
    rng = np.random.default_rng(SEED)
    _, *kind = name.split()
    count = vertex_count(name)
    kinds: dict[str, Callable[[], Triangles]] = {
        "": lambda: meshes.refine(base, count, rng),
        "cotangent": lambda: meshes.refine(base, count, rng),
        "shuffled": lambda: meshes.shuffle(meshes.refine(base, count, rng), rng),
        "tube": lambda: meshes.tube(count, 40, rng),
    }
    if kind == ["pieces"]:
        piece = meshes.ball(count // 500, rng)
        patches = far_apart_discs(surface.Mesh(*piece), 4, 0.015)
        return with_paint(meshes.copies(piece, 500), [tile(patch, len(piece.positions)) for patch in patches], rng)
    mesh = kinds[" ".join(kind)]()
    scene = with_paint(mesh, far_apart_discs(surface.Mesh(*mesh), 12), rng)
    return replace(scene, **cotangent_stiffness(mesh)) if kind == ["cotangent"] else scene


def tile(patch: Indices, step: int) -> Indices:
    """The same patch on each of 500 copies."""
    return (patch + step * np.arange(500)[:, None]).ravel().astype(np.int32)


def with_paint(triangles: Triangles, patches: list[Indices], rng: np.random.Generator) -> Scene:
    """One half of the patches for the first painting, the other for the second; strokes anywhere."""
    mesh = surface.Mesh(*triangles)
    near = neighbours(mesh)
    centres = rng.choice(mesh.vertex_count, STROKES, replace=False)
    sizes = {"stroke": max(1, round(STROKE_SHARE * mesh.vertex_count)), "dab": DAB}
    strokes = {kind: [grow_disc(near, mesh.positions, int(c), size) for c in centres] for kind, size in sizes.items()}
    half = len(patches) // 2
    return Scene(
        triangles.positions,
        triangles.faces,
        **stiffness(mesh.vertex_count, mesh.edges, np.ones(mesh.edge_count)),
        first=prescribe(mesh.vertex_count, patches[:half]),
        second=prescribe(mesh.vertex_count, patches[half:]),
        stroke=np.array(strokes["stroke"]),
        dab=np.array(strokes["dab"]),
        reference=np.empty(0),
    )


def prescribe(count: int, patches: list[Indices]) -> Reals:
    """Values from 0 to 1."""
    result = np.full(count, np.nan)
    for patch, value in zip(patches, np.linspace(0.0, 1.0, len(patches))):
        result[patch] = value
    return result


def cotangent_stiffness(mesh: Triangles) -> dict[str, Any]:
    """Half the cotangents of the angles opposite an edge: negative where these are obtuse. Positive semi-definite all
    the same, being the sum of the Dirichlet energies of linear functions on triangles, none of which is degenerate."""
    corners = [mesh.positions[mesh.faces[:, k]] for k in range(3)]
    ends, weights = [], []
    for k in range(3):
        u, v = (corners[(k + step) % 3] - corners[k] for step in (1, 2))
        weights.append(0.5 * np.einsum("ij,ij->i", u, v) / np.linalg.norm(np.cross(u, v), axis=1))
        ends.append(np.roll(mesh.faces, -k, axis=1)[:, 1:])
    return stiffness(len(mesh.positions), np.concatenate(ends), np.concatenate(weights))


def stiffness(size: int, ends: Indices, weights: Reals) -> dict[str, Any]:
    """Of edges (E, 2) with weights (E,), which add up where an edge comes again: those fields of the scene."""
    diagonal = np.bincount(ends.ravel(), np.repeat(weights, 2), minlength=size)
    rows = np.concatenate([np.arange(size), ends.max(axis=1)])
    columns = np.concatenate([np.arange(size), ends.min(axis=1)])
    lower = scipy.sparse.csc_matrix((np.concatenate([diagonal, -weights]), (rows, columns)), (size, size))
    lower.sort_indices()
    return {
        "stiffness_offsets": lower.indptr.astype(np.int32),
        "stiffness_rows": lower.indices.astype(np.int32),
        "stiffness_values": lower.data,
    }


if __name__ == "__main__":
    main(sys.argv[1], *map(Path, sys.argv[2:]))
