# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh data-blocks as arrays."""

from __future__ import annotations

from math import hypot
from typing import Any, NamedTuple

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say

# foreach_get is fast only into a buffer of Blender's own C type: float32 for coordinates, unsigned for indices.


def require_mesh(obj: bpy.types.Object) -> None:
    """Raises InputError unless the object is a mesh whose data can be read now."""
    if obj.type != "MESH":
        raise library.load().InputError(
            say("object '{object}' is not a mesh but of type {type}", object=obj.name, type=obj.type)
        )
    if obj.mode == "EDIT":
        raise library.load().InputError(
            say("object '{object}' is in Edit Mode: leave it first, its mesh cannot be read", object=obj.name)
        )


class Arrays(NamedTuple):
    """A mesh data-block in numbers, in object space, without modifiers or shape keys."""

    positions: NDArray[np.float32]  # (V, 3)
    offsets: NDArray[np.int32]  # (F + 1,)
    corners: NDArray[np.int32]  # (C,)

    @property
    def diagonal(self) -> float:
        """Of the bounding box; 0 without vertices."""
        return _diagonal(self.positions)

    def same_faces(self, other: Arrays) -> bool:
        return (
            len(self.positions) == len(other.positions)
            and np.array_equal(self.offsets, other.offsets)
            and np.array_equal(self.corners, other.corners)
        )

    def same(self, other: Arrays) -> bool:
        return self.same_faces(other) and np.array_equal(self.positions, other.positions)


def read_arrays(mesh: bpy.types.Mesh) -> Arrays:
    return Arrays(_read_positions(mesh), *read_polygons(mesh))


def build(arrays: Arrays, known: Any = None):
    """The dirichlet_surface.Mesh; known: one of the same faces. Raises the library's InputError (no faces, a coordinate
    that is not finite) and TopologyError."""
    if known:
        return known.moved(arrays.positions)
    return library.load().Mesh(arrays.positions.astype(np.float64), (arrays.offsets, arrays.corners))


def read_mesh(mesh: bpy.types.Mesh):
    """The dirichlet_surface.Mesh of a mesh data-block. Raises what `build` raises."""
    return build(read_arrays(mesh))


def read_positions(mesh: bpy.types.Mesh) -> NDArray[np.float64]:
    """(V, 3)"""
    return _read_positions(mesh).astype(np.float64)


def _read_positions(mesh: bpy.types.Mesh) -> NDArray[np.float32]:
    positions = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", positions)
    return positions.reshape(-1, 3)


def read_polygons(mesh: bpy.types.Mesh) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """Offsets (F + 1,) and corners (C,)."""
    corners = np.empty(len(mesh.loops), np.uint32)
    offsets = np.empty(len(mesh.polygons) + 1, np.uint32)
    mesh.polygons.foreach_get("loop_start", offsets[:-1])
    offsets[-1] = len(corners)
    stored = mesh.attributes.get(".corner_vert")  # from Blender 3.6 on, and many times faster there
    if stored:
        stored.data.foreach_get("value", corners.view(np.int32))
        return offsets.view(np.int32), corners.view(np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    sizes = np.empty(len(mesh.polygons), np.uint32)
    mesh.polygons.foreach_get("loop_total", sizes)
    if not np.array_equal(np.diff(offsets), sizes):  # before Blender 3.6 faces may own any stretch of the loops
        starts, offsets = offsets[:-1].astype(np.int64), np.concatenate(([0], np.cumsum(sizes, dtype=np.int64)))
        _require_stretches(mesh, starts, starts + sizes)
        corners = corners[np.repeat(starts - offsets[:-1], sizes) + np.arange(offsets[-1])]
    return offsets.astype(np.int32, copy=False), corners.view(np.int32)


def _require_stretches(mesh: bpy.types.Mesh, starts: NDArray[np.int64], ends: NDArray[np.int64]) -> None:
    beyond = np.flatnonzero(ends > len(mesh.loops))
    if beyond.size:
        raise library.load().InputError(
            say(
                "face {face} of mesh '{mesh}' begins at corner {first} and ends before {end}, but the mesh has {count} "
                "corners",
                face=beyond[0],
                mesh=mesh.name,
                first=starts[beyond[0]],
                end=ends[beyond[0]],
                count=len(mesh.loops),
            )
        )


def read_edges(mesh: bpy.types.Mesh) -> NDArray[np.int32]:
    """(E, 2). Raises InputError for an edge that ends at no vertex."""
    edges = np.empty(2 * len(mesh.edges), np.uint32)
    mesh.edges.foreach_get("vertices", edges)
    beyond = np.flatnonzero(edges >= len(mesh.vertices))
    if beyond.size:
        raise library.load().InputError(
            say(
                "edge {edge} of mesh '{mesh}' ends at vertex {vertex}, but the vertices are 0 to {last}",
                edge=beyond[0] // 2,
                mesh=mesh.name,
                vertex=edges.view(np.int32)[beyond[0]],
                last=len(mesh.vertices) - 1,
            )
        )
    return edges.view(np.int32).reshape(-1, 2)


def selected_vertices(mesh: bpy.types.Mesh) -> NDArray[np.intp]:
    """Indices, ascending."""
    selected = np.empty(len(mesh.vertices), bool)
    mesh.vertices.foreach_get("select", selected)
    return np.flatnonzero(selected)


def diagonal(mesh: bpy.types.Mesh) -> float:
    """Of the bounding box, in object space; 0 without vertices."""
    return _diagonal(_read_positions(mesh))


def _diagonal(positions: NDArray[np.float32]) -> float:
    if not len(positions):
        return 0.0
    # Axis by axis, which NumPy is several times quicker at; in float32 the size of a huge mesh is infinite.
    return hypot(*(float(axis.max()) - float(axis.min()) for axis in positions.T))
