# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygon meshes: from arrays, from files, and what there is to ask of them."""

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import as_indices, as_reals, require_shape
from ._native import InputError


class Mesh(_native.Mesh):
    """A polygon mesh and its connectivity. Immutable; safe to read from several threads.

    Any number of corners per face, faces per edge, any orientation, vertices without a face: all legal. A corner
    repeated in direct succession (the quad a b c c) counts once.

    positions  (V, 3) finite, any unit. float64 in C order is used in place: writing to it later moves the mesh.
    faces      (F, 3) or (F, 4) vertex indices, any (F, k) in fact; or (offsets (F + 1,), corners (C,)) for faces of
               mixed sizes: face f is corners[offsets[f]:offsets[f + 1]]. Copied.

    Raises InputError (lengths, no faces, a number that is not finite, an index out of range) or TopologyError (a face
    with fewer than three vertices, or one twice), naming the first offender. Cost: O(V + C).
    """

    def __init__(self, positions: ArrayLike, faces: ArrayLike | tuple[ArrayLike, ArrayLike]) -> None:
        points = as_reals(positions, "positions")
        require_shape(points, (None, 3), "positions")
        if isinstance(faces, tuple) and len(faces) == 2:
            offsets, corners = as_indices(faces[0], "face offsets"), as_indices(faces[1], "face corners")
            require_shape(offsets, (None,), "face offsets")
            require_shape(corners, (None,), "face corners")
            super().__init__(points, offsets, corners)
        else:
            corners = as_indices(faces, "faces")
            if corners.size == 0:
                raise InputError("the mesh has no faces")
            require_shape(corners, (None, None), "faces")
            super().__init__(points, corners)

    def __repr__(self) -> str:
        return f"Mesh({self.vertex_count} vertices, {self.edge_count} edges, {self.face_count} faces)"


def require_mesh(mesh: Mesh) -> None:
    """Refuses what is none, such as the arrays that one is made of."""
    if not isinstance(mesh, Mesh):
        raise InputError(f"this needs a Mesh, not {type(mesh).__name__}")


def read_mesh(path: str | os.PathLike[str]) -> Mesh:
    """The mesh in an OBJ, PLY, OFF or STL file, told apart by its ending; non-manifold faces are kept.

    Raises InputError (naming the file and the line or byte) where it is unreadable or damaged, and what Mesh raises.
    """
    positions, offsets, corners = _native.read_mesh_file(os.fspath(path))
    return Mesh(positions, (offsets, corners))


def write_mesh(path: str | os.PathLike[str], mesh: Mesh, colors: ArrayLike | None = None) -> None:
    """Writes OBJ, PLY, OFF or STL, by the ending. colors: (V, 3) in 0 … 255, for PLY.

    An error leaves what was there. Raises InputError: unwritable, unknown ending, colours where there is no room.
    """
    require_mesh(mesh)
    bytes_ = None
    if colors is not None:
        numbers = as_indices(colors, "colors")
        require_shape(numbers, (mesh.vertex_count, 3), "colors")
        if numbers.size and (numbers.min() < 0 or numbers.max() > 255):
            raise InputError("colors have to lie between 0 and 255")
        bytes_ = numbers.astype(np.uint8)
    _native.write_mesh_file(os.fspath(path), mesh, bytes_)


@dataclass(frozen=True)
class PatchFacts:
    """What a painted patch is: the part of the mesh spanned by its vertices, with their edges and full faces."""

    vertices: int
    edges: int
    faces: int
    components: int
    """connected pieces"""
    euler_characteristic: int
    """vertices - edges + faces"""
    border_loops: int
    """of its faces; 0 where they are not manifold"""
    manifold: bool
    disc: bool
    """manifold, connected, Euler characteristic 1, one border loop, no loose edge"""
    overlaps: tuple[int, ...]
    """the other patches that share a vertex with it"""


def inspect_patches(mesh: Mesh, patches: Sequence[ArrayLike]) -> list[PatchFacts]:
    """The facts of every patch, given as vertex indices (c,) each; nothing is refused but an index out of range.

    Cost: O(V + the patches and their one-rings).
    """
    require_mesh(mesh)
    arrays: list[NDArray[np.int32]] = []
    for number, patch in enumerate(patches):
        arrays.append(as_indices(patch, f"the vertices of patch {number}"))
        require_shape(arrays[-1], (None,), f"the vertices of patch {number}")
    return [PatchFacts(**facts) for facts in _native.inspect_patches(mesh, arrays)]
