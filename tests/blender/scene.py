# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects to test on, how to paint them, and what can be seen of them."""

import bmesh
import bpy
import numpy as np


def grid(columns=12, rows=7, name="Grid"):
    """A flat grid of quads, `columns` by `rows` vertices, vertex (x, y) at index x + columns * y."""
    positions = [(x, y, 0.0) for y in range(rows) for x in range(columns)]
    corner = [x + columns * y for y in range(rows - 1) for x in range(columns - 1)]
    return add(positions, [(c, c + 1, c + columns + 1, c + columns) for c in corner], name)


def painted_grid(columns=12, rows=7, name="Grid"):
    """A grid painted 0 on its left column and 1 on its right."""
    obj = grid(columns, rows, name)
    paint(obj, "left", range(0, columns * rows, columns), 0.0)
    paint(obj, "right", range(columns - 1, columns * rows, columns), 1.0)
    return obj


def painted_sphere(subdivisions=4, name="Sphere"):
    """A closed surface, painted 0 near its lowest point and 1 near its highest."""
    mesh = bpy.data.meshes.new(name)
    editor = bmesh.new()
    bmesh.ops.create_icosphere(editor, subdivisions=subdivisions, radius=1.0)
    editor.to_mesh(mesh)
    editor.free()
    obj = link(mesh, name)
    heights = np.array([vertex.co.z for vertex in mesh.vertices])
    paint(obj, "bottom", np.flatnonzero(heights < -0.9), 0.0)
    paint(obj, "top", np.flatnonzero(heights > 0.9), 1.0)
    return obj


def add(positions, faces, name="Mesh"):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions, [], faces)
    return link(mesh, name)


def link(mesh, name):
    """A new object on the mesh, in the scene and active."""
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    return obj


def paint(obj, group, vertices, value=0.0, weight=1.0):
    """Assigns the vertices to a group, made and put into the list of patches if it is new; returns its patch."""
    if group not in obj.vertex_groups:
        obj.vertex_groups.new(name=group)
    obj.vertex_groups[group].add([int(vertex) for vertex in vertices], weight, "REPLACE")
    patch = next((patch for patch in obj.dirichlet.patches if patch.group == group), None)
    if patch is None:
        patch = obj.dirichlet.patches.add()
        patch.group, patch.value = group, value
    return patch


def select(obj, vertices):
    """These vertices alone, and no edge or face, so that Edit Mode keeps the selection."""
    edited = bmesh.new()  # setting `select` of an edge crashes Blender 5.0.1
    edited.from_mesh(obj.data)
    for item in (*edited.edges, *edited.faces):
        item.select = False
    for vertex in edited.verts:
        vertex.select = vertex.index in vertices
    edited.to_mesh(obj.data)
    edited.free()


def field_of(obj):
    """dirichlet_field, (V,) float32"""
    values = np.empty(len(obj.data.vertices), np.float32)
    obj.data.attributes["dirichlet_field"].data.foreach_get("value", values)
    return values


def colors_of(obj):
    """dirichlet_color, (V, 4) float32"""
    colors = np.empty((len(obj.data.vertices), 4), np.float32)
    obj.data.attributes["dirichlet_color"].data.foreach_get("color", colors.ravel())
    return colors


def library_mesh(surface, obj):
    """The library's mesh, read without the add-on."""
    faces = [tuple(polygon.vertices) for polygon in obj.data.polygons]
    offsets = np.cumsum([0, *map(len, faces)])
    return surface.Mesh([tuple(vertex.co) for vertex in obj.data.vertices], (offsets, np.concatenate(faces)))
