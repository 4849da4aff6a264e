# SPDX-License-Identifier: GPL-3.0-or-later
"""Results as numbers, and mesh objects whose shape is not that of their mesh."""

import bpy
import numpy as np
from scene import field_of


def levels(result):
    return list(result.data["dirichlet_level"])


def points(result):
    """(P, 3) of all splines."""
    return np.array([point.co[:3] for spline in result.data.splines for point in spline.points], np.float32)


def add_shape_key(obj, value=1.0):
    """Raises every vertex by x y / 8; returns the key."""
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Bent")
    for vertex, item in zip(obj.data.vertices, key.data, strict=True):
        item.co.z = vertex.co.x * vertex.co.y / 8
    key.value = value
    return key


def add_wave(obj):
    """A modifier that keeps the faces."""
    modifier = obj.modifiers.new("Bend", "SIMPLE_DEFORM")
    modifier.deform_method, modifier.angle, modifier.deform_axis = "BEND", 1.0, "Z"


def points_on_shape(surface, obj):
    """What the library extracts from the mesh as Blender shows it."""
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    positions = [tuple(vertex.co) for vertex in mesh.vertices]
    shape = surface.Mesh(positions, np.array([tuple(polygon.vertices) for polygon in mesh.polygons]))
    return surface.isolines(shape, field_of(obj), surface.even_levels(0, 1, obj.dirichlet.count)).points
