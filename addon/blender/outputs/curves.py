# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as the curves data-block of geometry nodes and hair: one poly curve per line, with attributes.

Python can add curves to it from Blender 4.x on; before, ui/line_properties.py does not offer it.
"""

from __future__ import annotations

import bpy
import numpy as np

from . import materials
from .drawing import Drawing
from .line_attributes import put, write_attributes

TYPE = "CURVES"
_POLY = 1


def new(name: str, drawing: Drawing) -> bpy.types.Curves:
    return bpy.data.hair_curves.new(name)


def write(curves: bpy.types.Curves, drawing: Drawing, name: str) -> None:
    if len(curves.curves):
        curves.remove_curves()
    if len(drawing.sizes):
        curves.add_curves(drawing.sizes.tolist())
        curves.position_data.foreach_set("vector", drawing.points.ravel())
        _make_poly(curves)
        put(curves, "cyclic", "BOOLEAN", "CURVE", drawing.closed)
        write_attributes(curves, drawing, "CURVE")
    materials.show_attribute(curves.materials, name)


def _make_poly(curves: bpy.types.Curves) -> None:
    """Where there is a function for it, writing the attribute is not safe."""
    if hasattr(curves, "set_types"):
        curves.set_types(type="POLY")
    else:
        put(curves, "curve_type", "INT8", "CURVE", np.full(len(curves.curves), _POLY, np.int8))
