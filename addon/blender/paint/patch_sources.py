# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets of vertices that a mesh has already, to make patches of."""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import partial
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import counted, say
from ..held import Held
from ..mesh import meshes, sessions
from ..work import Made, Step, Work
from . import patches

MOST = 64  # patches made at once: more are a mistake, such as colours that blend into each other

Sets = list[NDArray[np.intp]]
Finding = Generator[Step, Any, Sets]  # part of a work

_CHANNELS = {"INT": ("value", 1, np.int32), "INT8": ("value", 1, np.int8), "BOOLEAN": ("value", 1, np.bool_),
             "FLOAT": ("value", 1, np.float32), "FLOAT_COLOR": ("color", 4, np.float32),
             "BYTE_COLOR": ("color", 4, np.float32)}  # fmt: skip
_SHADES = 65535  # steps that a colour's channel is told apart by: finer than any byte colour's


def from_borders(obj: bpy.types.Object) -> Work:
    """A patch for every border; returns Made. Raises InputError when the mesh is closed or has too many borders."""
    held = Held(obj)
    return _add_patches(held, "Border", _border_loops(held))


def from_pieces(obj: bpy.types.Object) -> Work:
    """A patch for every connected piece; returns Made. Raises InputError when there are none or too many."""
    held = Held(obj)
    return _add_patches(held, "Piece", _pieces(held))


def from_attribute(obj: bpy.types.Object, name: str, background: bool) -> Work:
    """A patch for every set of connected vertices that share a value of the attribute, for every value; of values on
    corners, edges or faces, a vertex has the one that all around it agree on, and none where they do not.

    background: leave out the most frequent value, which then has no say around a vertex. Returns Made. Raises
    InputError for an attribute that is not there or has no such values, and when there are none or too many.
    """
    held = Held(obj)  # the patches do not have the attribute's own name, which would then stand for both
    return _add_patches(held, f"{name} island", _attribute_islands(held, name, background))


def _add_patches(held: Held, name: str, finding: Finding) -> Work:
    """A patch named so for every set of vertices that is found."""
    sets = yield from finding
    obj = held.find_mesh()
    for vertices in sets:
        patches.add_group(obj, name, vertices)
    patches.recheck(obj)
    return Made([], counted(len(sets), "1 patch added", "{count} patches added"))


def _border_loops(held: Held) -> Finding:
    session = yield from sessions.opening(held)
    offsets, vertices = yield Step(held.name, 0.5, session.mesh.border_loops)
    loops = np.split(np.asarray(vertices), offsets[1:-1]) if len(offsets) > 1 else []
    return _require_some(loops, say("border loops of mesh '{mesh}'", mesh=held.find_mesh().data.name))


def _pieces(held: Held) -> Finding:
    mesh = _read_mesh(held)
    labels = np.zeros(len(mesh.vertices), np.int64)
    found = yield Step(held.name, 0.3, partial(islands, labels, meshes.read_edges(mesh)))
    return _require_some(found, say("connected pieces of mesh '{mesh}'", mesh=held.find_mesh().data.name))


def _attribute_islands(held: Held, name: str, background: bool) -> Finding:
    mesh = _read_mesh(held)
    values = _read(mesh, name)
    to_vertices = _vertices_of(mesh, mesh.attributes[name].domain)
    edges = meshes.read_edges(mesh)

    def find() -> Sets:
        numbers = _distinct(values)
        if background:
            numbers[numbers == np.bincount(numbers).argmax()] = -1
        return islands(to_vertices(numbers), edges)

    found = yield Step(held.name, 0.3, find)
    return _require_some(found, say("islands of attribute '{name}'", name=name))


def _read_mesh(held: Held) -> bpy.types.Mesh:
    """The mesh, which is to stay as it is now."""
    mesh = held.find_mesh().data
    held.keep(meshes.read_arrays(mesh))
    return mesh


def islands(labels: NDArray[np.int64], edges: NDArray[np.int32]) -> Sets:
    """The vertices, ascending, of every set connected by edges (E, 2) inside one label (V,); a label below 0 is none.

    The sets are in the order of their lowest vertices. Cost: a few sweeps over the edges.
    """
    root = np.arange(len(labels))  # of a tree to the lowest vertex found yet
    open_edges = edges[labels[edges[:, 0]] == labels[edges[:, 1]]]
    while len(open_edges):
        ends = np.sort(root[open_edges], axis=1)
        root[ends[:, 1]] = ends[:, 0]
        while not np.array_equal(root, above := root[root]):
            root = above
        open_edges = open_edges[np.not_equal(*root[open_edges].T)]
    kept = np.flatnonzero(labels >= 0)
    kept = kept[np.argsort(root[kept], kind="stable")]
    return np.split(kept, 1 + np.flatnonzero(np.diff(root[kept]))) if len(kept) else []


def _read(mesh: bpy.types.Mesh, name: str) -> NDArray[np.generic]:
    """(N,) or (N, 4) as stored."""
    attribute = mesh.attributes.get(name)
    if attribute is None:
        if name:
            missing = say("mesh '{mesh}' has no attribute '{name}'", mesh=mesh.name, name=name)
        else:
            missing = say("mesh '{mesh}' has no color attribute of its own: name an attribute", mesh=mesh.name)
        raise library.load().InputError(missing)
    if attribute.data_type not in _CHANNELS:
        raise library.load().InputError(
            say(
                "attribute '{name}' is of type {type}: colors, integers, booleans and floats have islands",
                name=name,
                type=attribute.data_type,
            )
        )
    key, channels, kind = _CHANNELS[attribute.data_type]
    values = np.empty(len(attribute.data) * channels, kind)
    attribute.data.foreach_get(key, values)
    return values.reshape(-1, channels) if channels > 1 else values


def _distinct(values: NDArray[np.generic]) -> NDArray[np.int64]:
    """(N,) a number from 0 for every different value, or row of values."""
    if values.ndim == 2:
        shades = np.rint(np.clip(values, 0, 1) * _SHADES).astype(np.uint64)
        values = shades @ (np.uint64(_SHADES + 1) ** np.arange(4, dtype=np.uint64))
    return np.unique(values, return_inverse=True)[1].astype(np.int64)


def _vertices_of(mesh: bpy.types.Mesh, domain: str) -> Callable[[NDArray[np.int64]], NDArray[np.int64]]:
    """What makes labels (V,) of those of the domain's items, in any thread: -1 where there is none or they disagree."""
    if domain == "POINT":
        return lambda values: values
    count = len(mesh.vertices)
    if domain == "EDGE":
        return partial(_agree, count, meshes.read_edges(mesh).ravel(), 2)
    offsets, vertices = meshes.read_polygons(mesh)
    return partial(_agree, count, vertices, np.diff(offsets) if domain == "FACE" else 1)


def _agree(
    count: int, vertices: NDArray[np.int32], times: int | NDArray[np.int32], values: NDArray[np.int64]
) -> NDArray[np.int64]:
    """Labels (count,) of what stands at the vertices: values (N,), each so many times."""
    values = np.repeat(values, times)
    voting = values >= 0
    vertices, values = vertices[voting], values[voting]
    labels = np.full(count, -1, np.int64)
    labels[vertices] = values
    labels[vertices[labels[vertices] != values]] = -1
    return labels


def _require_some(sets: Sets, what: str) -> Sets:
    if not sets:
        raise library.load().InputError(say("there are no {what}", what=what))
    if len(sets) > MOST:
        raise library.load().InputError(
            say(
                "there are {count} {what}, more than the {most} that become patches",
                count=len(sets),
                what=what,
                most=MOST,
            )
        )
    return sets
