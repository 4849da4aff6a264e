# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as the curves data-block of geometry nodes and hair: one poly curve per line, with attributes.

This is offered where Blender has a function that sets their type: written as an attribute it crashes 4.3 and 5.2.
"""

from __future__ import annotations

import bpy

from . import materials
from .drawing import Drawing
from .line_attributes import put, write_attributes

TYPE = "CURVES"


def new(name: str, drawing: Drawing) -> bpy.types.Curves:
    return bpy.data.hair_curves.new(name)


def write(curves: bpy.types.Curves, drawing: Drawing, name: str) -> None:
    if len(curves.curves):
        curves.remove_curves()
    if len(drawing.sizes):
        curves.add_curves(drawing.sizes.tolist())
        curves.position_data.foreach_set("vector", drawing.points.ravel())
        curves.set_types(type="POLY")
        put(curves, "cyclic", "BOOLEAN", "CURVE", drawing.closed)
        write_attributes(curves, drawing, "CURVE")
    materials.show_attribute(curves.materials, name)
