# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex groups as arrays.

Blender has no bulk access to vertex weights. Geometry nodes do: evaluated on a temporary object of the same mesh, they
copy every group into an ordinary attribute. They take time by the group, and know a group by its name alone, which a UV
map or a color attribute may share: a walk over the vertices does neither. Nothing temporary is left behind. A vertex
outside a group reads as weight 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import bpy
import numpy as np
from numpy.typing import NDArray

_BATCH = 32  # groups evaluated at once: bounds the memory
_MANY = 256  # groups from which on the walk is quicker
_TEMPORARY = "Dirichlet weights"  # name of what does not stay


def read_weights(mesh: bpy.types.Mesh, names: Sequence[str]) -> Iterator[NDArray[np.float32]]:
    """(V,) weights in [0, 1] of every group named, in that order; all of them exist."""
    if len(names) >= _MANY or any(name in mesh.attributes or name in mesh.uv_layers for name in names):
        yield from _walk(mesh, names)
        return
    for start in range(0, len(names), _BATCH):
        batch = names[start : start + _BATCH]
        weights = np.empty((len(batch), len(mesh.vertices)), np.float32)
        with _evaluated(mesh, batch) as attributes:
            for k in range(len(batch)):
                attributes[_stored_name(k)].data.foreach_get("value", weights[k])
        yield from weights  # once nothing temporary is left: whoever takes them may fail, and keep this open for long


def add_group(obj: bpy.types.Object, name: str, vertices: Sequence[int] | NDArray[np.intp]) -> str:
    """Makes a vertex group with these vertices at weight 1, and makes it active, so that it is painted on; returns the
    name that Blender gave it."""
    group = obj.vertex_groups.new(name=name)
    group.add(np.asarray(vertices, np.intp).tolist(), 1.0, "REPLACE")
    obj.vertex_groups.active = group
    return group.name


def copy_group(obj: bpy.types.Object, name: str) -> str:
    """Copies the group and its weights, makes the copy active and returns its name: the next that is free."""
    obj.vertex_groups.active_index = obj.vertex_groups[name].index
    with bpy.context.temp_override(object=obj, active_object=obj):  # the one bulk copy that there is
        bpy.ops.object.vertex_group_copy()
    copy = obj.vertex_groups.active
    copy.name = name
    return copy.name


def _walk(mesh: bpy.types.Mesh, names: Sequence[str]) -> Iterator[NDArray[np.float32]]:
    """As `read_weights`, in one pass over the vertices in Python: some 1 µs for each, and for each of its groups."""
    with _stand_in(mesh) as obj:
        indices = {group.name: group.index for group in obj.vertex_groups}
    kinds = [("vertex", np.int32), ("group", np.int32), ("weight", np.float32)]
    entries = ((vertex, held.group, held.weight) for vertex, item in enumerate(mesh.vertices) for held in item.groups)
    assigned = np.fromiter(entries, kinds)
    assigned = assigned[np.argsort(assigned["group"], kind="stable")]
    for index in map(indices.__getitem__, names):
        start, end = np.searchsorted(assigned["group"], (index, index + 1))
        weights = np.zeros(len(mesh.vertices), np.float32)
        weights[assigned["vertex"][start:end]] = assigned["weight"][start:end]
        yield weights


@contextmanager
def _stand_in(mesh: bpy.types.Mesh) -> Iterator[bpy.types.Object]:
    """A temporary object of the mesh: it has the groups' names."""
    obj, empty = bpy.data.objects.new(_TEMPORARY, mesh), bpy.data.meshes.new(_TEMPORARY)
    try:
        yield obj
    finally:
        obj.data = empty  # Blender evaluates the mesh of a removed object again, wherever else it is used
        bpy.data.objects.remove(obj)
        bpy.data.meshes.remove(empty)


@contextmanager
def _evaluated(mesh: bpy.types.Mesh, names: Sequence[str]) -> Iterator[bpy.types.bpy_prop_collection]:
    """The attributes of the mesh with the groups stored among them."""
    tree, scene = _tree(names), bpy.data.scenes.new(_TEMPORARY)
    try:
        with _stand_in(mesh) as obj:
            scene.collection.objects.link(obj)
            obj.modifiers.new(tree.name, "NODES").node_group = tree
            scene.view_layers[0].update()
            yield obj.evaluated_get(scene.view_layers[0].depsgraph).data.attributes
    finally:
        bpy.data.scenes.remove(scene)
        bpy.data.node_groups.remove(tree)


def _tree(names: Sequence[str]) -> bpy.types.NodeTree:
    """Geometry in, a Store Named Attribute per group, geometry out."""
    tree = bpy.data.node_groups.new(_TEMPORARY, "GeometryNodeTree")
    _add_geometry_sockets(tree)
    last = tree.nodes.new("NodeGroupInput").outputs[0]
    for k, name in enumerate(names):
        weight = tree.nodes.new("GeometryNodeInputNamedAttribute")
        weight.data_type = "FLOAT"
        weight.inputs["Name"].default_value = name
        store = tree.nodes.new("GeometryNodeStoreNamedAttribute")
        store.data_type, store.domain = "FLOAT", "POINT"
        store.inputs["Name"].default_value = _stored_name(k)
        tree.links.new(_enabled(weight.outputs, "Attribute"), _enabled(store.inputs, "Value"))
        tree.links.new(last, store.inputs["Geometry"])
        last = store.outputs["Geometry"]
    tree.links.new(last, tree.nodes.new("NodeGroupOutput").inputs[0])
    return tree


def _stored_name(k: int) -> str:
    return f".dirichlet_weight_{k}"


def _enabled(sockets, name: str) -> bpy.types.NodeSocket:
    """Nodes carry a socket of one name per data type, of which one is enabled."""
    return next(socket for socket in sockets if socket.enabled and socket.name == name)


def _add_geometry_sockets(tree: bpy.types.NodeTree) -> None:
    if bpy.app.version >= (4, 0, 0):
        tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
