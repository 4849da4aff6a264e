# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygon meshes: from arrays, from files, and what there is to ask of them."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import as_array, as_indices, as_reals, require_shape
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
        if isinstance(faces, tuple) and _are_offsets_and_corners(faces):
            offsets, corners = as_indices(faces[0], "face offsets"), as_indices(faces[1], "face corners")
            require_shape(offsets, (None,), "face offsets")
            require_shape(corners, (None,), "face corners")
            super().__init__(points, offsets, corners)
        else:
            corners = as_indices(cast(ArrayLike, faces), "faces")
            if corners.size == 0:
                raise InputError("the mesh has no faces")
            require_shape(corners, (None, None), "faces")
            super().__init__(points, corners)

    def moved(self, positions: ArrayLike) -> Mesh:
        """The same faces with the vertices elsewhere, (V, 3), as of a surface that is animated: their connectivity is
        copied, not found again. Raises InputError for another number of vertices, or a number that is not finite."""
        points = as_reals(positions, "positions")
        require_shape(points, (self.vertex_count, 3), "positions")
        mesh = Mesh.__new__(Mesh)
        _native.Mesh.__init__(mesh, self, points)
        return mesh

    def __repr__(self) -> str:
        return f"Mesh({self.vertex_count} vertices, {self.edge_count} edges, {self.face_count} faces)"


def _are_offsets_and_corners(faces: tuple[ArrayLike, ...]) -> bool:
    """Whether a tuple is that pair, and not the faces themselves: two of one size are as long as each other, which the
    pair is only where a face is empty."""
    if len(faces) != 2:
        return False
    offsets = as_array(faces[0], "face offsets")
    if offsets.size != as_array(faces[1], "face corners").size:
        return True
    first = np.ravel(offsets).tolist()
    return first[:1] == [0] and first[-1] == len(first) and len(set(first)) < len(first)


def require_mesh(mesh: Mesh) -> None:
    """Refuses what is none, such as the arrays that one is made of."""
    if not isinstance(mesh, Mesh):
        raise InputError(f"this needs a Mesh, not {type(mesh).__name__}")


@dataclass(frozen=True)
class Defects:
    """What is legal in a mesh but seldom meant. A field is solved all the same, with these warnings in its report."""

    repeated_faces: int
    """round the same vertices as an earlier face; they count once"""
    flat_faces: int
    """without an area, as far as rounded coordinates can tell"""
    crossing_faces: int
    """quads, and polygons thinner than 1e-5, that cross themselves: their triangles lie on each other"""
    coincident_vertices: int
    """exactly where an earlier vertex is, both on a border or on two pieces, and not joined to it"""
    warnings: tuple[str, ...]


def find_defects(mesh: Mesh) -> Defects:
    """What to tell whoever made the mesh. Cost: O(V + C)."""
    require_mesh(mesh)
    return Defects(**_native.find_defects(mesh))


def read_mesh(path: str | bytes | os.PathLike[str]) -> Mesh:
    """The mesh in an OBJ, PLY, OFF or STL file, told apart by its ending; non-manifold faces are kept.

    Raises InputError (naming the file and the line or byte) where it is unreadable or damaged, and what Mesh raises.
    """
    positions, offsets, corners = _native.read_mesh_file(os.fsencode(path))
    return Mesh(positions, (offsets, corners))


def write_mesh(path: str | bytes | os.PathLike[str], mesh: Mesh, colors: ArrayLike | None = None) -> None:
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
    _native.write_mesh_file(os.fsencode(path), mesh, bytes_)


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
