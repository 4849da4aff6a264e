# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the scenes of the benchmark, once."""

import hashlib
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

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


def prepare(name: str, base: Path, store: Path, peers: Path) -> Path:
    """The folder of a scene, made now unless it was by the same code from the same base; `peers` solves its field."""
    mark = hashlib.sha256(base.read_bytes() if base.is_file() else b"torus")
    for source in (meshes.__file__, __file__):
        mark.update(Path(source).read_bytes())
    stem = name.replace(" ", "-")
    folder = store / f"{stem}-{mark.hexdigest()[:8]}"
    if not folder.is_dir():
        for outdated in store.glob(f"{stem}-{'?' * 8}"):
            shutil.rmtree(outdated)
        unfinished = folder.with_name("unfinished")
        save(make(name, meshes.read_base(base)), unfinished)
        subprocess.run([peers, "reference", unfinished, unfinished / "reference.npy", "1", "0"], check=True)
        unfinished.rename(folder)
    return folder


def make(name: str, base: Triangles) -> Scene:
    rng = np.random.default_rng(SEED)
    size, *kind = name.split()
    count = {"k": 1_000, "M": 1_000_000}[size[-1]] * int(size[:-1])
    kinds: dict[str, Callable[[], Triangles]] = {
        "": lambda: meshes.refine(base, count, rng),
        "shuffled": lambda: meshes.shuffle(meshes.refine(base, count, rng), rng),
        "tube": lambda: meshes.tube(count, 40, rng),
    }
    if kind == ["pieces"]:
        piece = meshes.ball(count // 500, rng)
        patches = far_apart_discs(surface.Mesh(*piece), 4, 0.015)
        return with_paint(meshes.copies(piece, 500), [tile(patch, len(piece.positions)) for patch in patches], rng)
    mesh = kinds[" ".join(kind)]()
    return with_paint(mesh, far_apart_discs(surface.Mesh(*mesh), 12), rng)


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
        *graph_stiffness(mesh),
        prescribe(mesh.vertex_count, patches[:half]),
        prescribe(mesh.vertex_count, patches[half:]),
        np.array(strokes["stroke"]),
        np.array(strokes["dab"]),
        np.empty(0),
    )


def prescribe(count: int, patches: list[Indices]) -> Reals:
    """Values from 0 to 1."""
    result = np.full(count, np.nan)
    for patch, value in zip(patches, np.linspace(0.0, 1.0, len(patches))):
        result[patch] = value
    return result


def graph_stiffness(mesh: surface.Mesh) -> tuple[Indices, Indices, Reals]:
    size, count = mesh.vertex_count, mesh.edge_count
    degree = np.bincount(mesh.edges.ravel(), minlength=size).astype(float)
    rows = np.concatenate([np.arange(size), mesh.edges[:, 1]])
    columns = np.concatenate([np.arange(size), mesh.edges[:, 0]])
    lower = scipy.sparse.csc_matrix((np.concatenate([degree, np.full(count, -1.0)]), (rows, columns)), (size, size))
    lower.sort_indices()
    return lower.indptr.astype(np.int32), lower.indices.astype(np.int32), lower.data
