# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as the edges of a mesh, with attributes per point: what geometry nodes take up as it is."""

from __future__ import annotations

import bpy

from . import materials
from .drawing import Drawing
from .line_attributes import write_attributes

TYPE = "MESH"


def new(name: str, drawing: Drawing) -> bpy.types.Mesh:
    return bpy.data.meshes.new(name)


def write(mesh: bpy.types.Mesh, drawing: Drawing, name: str) -> None:
    """Vertices in the order of the points, and the closing edge of every closed line."""
    edges = drawing.segments()
    mesh.clear_geometry()
    mesh.vertices.add(len(drawing.points))
    mesh.vertices.foreach_set("co", drawing.points.ravel())
    mesh.edges.add(len(edges))
    mesh.edges.foreach_set("vertices", edges.ravel())
    write_attributes(mesh, drawing, "POINT")
    materials.show_attribute(mesh.materials, name)
    mesh.update()
