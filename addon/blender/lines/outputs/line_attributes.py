# SPDX-License-Identifier: GPL-3.0-or-later
"""The attributes of isolines written as a mesh or as curves."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from ...names import CLOSED, COLOR, LENGTH, LEVEL, LINE
from .drawing import Drawing


def write_attributes(data: bpy.types.Mesh | bpy.types.Curves, drawing: Drawing, domain: str) -> None:
    """Of every line, per POINT or per CURVE; and per point the radius, which Mesh to Curve and renderers go by."""
    attributes = (
        (LEVEL, "FLOAT", drawing.levels[drawing.level].astype(np.float32)),
        (CLOSED, "BOOLEAN", drawing.closed),
        (LENGTH, "FLOAT", drawing.length.astype(np.float32)),
        (LINE, "INT", np.arange(len(drawing.length), dtype=np.int32)),
        (COLOR, "FLOAT_COLOR", drawing.colors[drawing.level]),
    )
    for name, kind, of_lines in attributes:
        put(data, name, kind, domain, np.repeat(of_lines, drawing.sizes, axis=0) if domain == "POINT" else of_lines)
    put(data, "radius", "FLOAT", "POINT", drawing.per_point(np.float32(drawing.radius) * drawing.factors))


def put(data: bpy.types.Mesh | bpy.types.Curves, name: str, kind: str, domain: str, values: NDArray) -> None:
    """Writes an attribute, made if there is none."""
    attribute = data.attributes.get(name) or data.attributes.new(name, kind, domain)
    attribute.data.foreach_set("color" if kind == "FLOAT_COLOR" else "value", values.ravel())
