# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of the library as an object in Blender."""

from __future__ import annotations

import bpy
import numpy as np


def add_mesh_object(mesh, name: str) -> bpy.types.Object:
    """Adds a dirichlet_surface.Mesh to the scene, in its own coordinates, selected and active."""
    data = bpy.data.meshes.new(name)
    data.vertices.add(mesh.vertex_count)
    data.vertices.foreach_set("co", mesh.positions.astype(np.float32).ravel())
    data.loops.add(len(mesh.corners))
    data.loops.foreach_set("vertex_index", mesh.corners)
    data.polygons.add(mesh.face_count)
    data.polygons.foreach_set("loop_start", mesh.offsets[:-1])
    data.polygons.foreach_set("loop_total", np.diff(mesh.offsets))
    data.update(calc_edges=True)
    obj = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(obj)
    for other in bpy.context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj
