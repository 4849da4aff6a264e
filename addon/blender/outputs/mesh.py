# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as the edges of a mesh, with attributes per point: what geometry nodes take up as it is."""

from __future__ import annotations

import bpy
import numpy as np

from . import materials
from .drawing import Drawing
from .line_attributes import write_attributes

TYPE = "MESH"


def new(name: str, drawing: Drawing) -> bpy.types.Mesh:
    return bpy.data.meshes.new(name)


def write(mesh: bpy.types.Mesh, drawing: Drawing, name: str) -> None:
    """Vertices in the order of the points, and the closing edge of every closed line."""
    count = len(drawing.points)
    following = np.arange(1, count + 1)
    last = drawing.offsets[1:] - 1
    following[last] = drawing.offsets[:-1]
    drawn = np.ones(count, bool)
    drawn[last[~drawing.closed]] = False
    drawn[last[drawing.closed & (drawing.sizes == 2)]] = False  # it would be the first edge again
    edges = np.column_stack((np.arange(count), following))[drawn]
    mesh.clear_geometry()
    mesh.vertices.add(count)
    mesh.vertices.foreach_set("co", drawing.points.ravel())
    mesh.edges.add(len(edges))
    mesh.edges.foreach_set("vertices", edges.astype(np.uint32).ravel())
    write_attributes(mesh, drawing, "POINT")
    materials.show_attribute(mesh.materials, name)
    mesh.update()
