# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as a legacy curve: one poly spline per line, tubes, a material per level.

Conversion and geometry nodes keep nothing of a spline but its points' radius and tilt, whether it is cyclic, and so its
length: the tilt, which turns a round tube without a trace, carries the level.
"""

from __future__ import annotations

from itertools import pairwise

import bpy
import numpy as np
from numpy.typing import NDArray

from ...names import CLOSED, LENGTH, LEVEL
from . import materials
from .drawing import Drawing

TYPE = "CURVE"
_MOST_MATERIALS = 64  # more levels than that share them, neighbour with neighbour


def new(name: str, drawing: Drawing) -> bpy.types.Curve:
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_resolution = 2
    curve.use_fill_caps = True
    curve.bevel_depth = drawing.radius
    return curve


def write(curve: bpy.types.Curve, drawing: Drawing, name: str) -> None:
    """Splines in the order of the lines; names of new materials start with `name`. The thickness stays."""
    count = min(len(drawing.levels), _MOST_MATERIALS)
    material_of_level = np.arange(len(drawing.levels)) * count // max(len(drawing.levels), 1)
    shown = [drawing.colors[material_of_level == k].mean(axis=0) for k in range(count)]
    materials.set_slots(curve.materials, name, np.array(shown))
    _set_splines(curve, drawing, material_of_level)
    curve[LEVEL] = drawing.levels[drawing.level].tolist()
    curve[CLOSED] = drawing.closed.astype(int).tolist()
    curve[LENGTH] = drawing.length.tolist()


def _set_splines(curve: bpy.types.Curve, drawing: Drawing, material_of_level: NDArray[np.intp]) -> None:
    curve.splines.clear()
    points = np.column_stack((drawing.points, np.ones(len(drawing.points), np.float32)))
    tilts = drawing.per_point(drawing.levels.astype(np.float32))
    radii = drawing.per_point(drawing.factors)
    slots = material_of_level[drawing.level].tolist()
    for (start, end), closed, slot in zip(pairwise(drawing.offsets.tolist()), drawing.closed.tolist(), slots):
        spline = curve.splines.new("POLY")
        spline.points.add(end - start - 1)
        spline.points.foreach_set("co", points[start:end].ravel())
        spline.points.foreach_set("tilt", tilts[start:end])
        spline.points.foreach_set("radius", radii[start:end])
        spline.use_cyclic_u = closed
        spline.material_index = slot
