# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines into result objects."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from ..mesh import meshes
from . import result_objects
from .outputs import curve, curves, mesh
from .outputs.drawing import draw

_OUTPUTS = {"CURVE": curve, "MESH": mesh, "CURVES": curves}  # by the property `output`


def write(
    source: bpy.types.Object,
    result: bpy.types.Object | None,
    lines,
    colors: NDArray[np.float32],
    factors: NDArray[np.float32],
) -> bpy.types.Object:
    """Puts lines into the result, or into a new one bound to the mesh object; one of another type than its settings'
    output is replaced. Returns the result.

    lines: the library's Isolines; colors: (K, 4) linear and factors: (K,) of the thickness, one per level.
    """
    settings = result_objects.settings_of(result, source)
    output = _OUTPUTS[settings.output]
    drawing = draw(lines, colors, factors, settings.bevel_depth * meshes.diagonal(source.data))
    if result is None:
        result = result_objects.add(source, output.new(f"{source.name}_isolines", drawing))
    elif result.type != output.TYPE:
        result = result_objects.replace(result, output.new(result.data.name, drawing))
    elif result.data.users > 1:  # of a linked duplicate, which keeps what it has
        result.data = result.data.copy()
    result_objects.link(result, source)
    output.write(result.data, drawing, source.name)
    result_objects.remember(result, source)
    return result


def set_thickness(settings: bpy.types.PropertyGroup) -> None:
    """Sets the tubes' radius of the mesh object's or the result's own curve; other outputs take it when next made."""
    owner = settings.id_data
    own = settings == owner.dirichlet_isolines
    source, result = (owner.dirichlet_isolines.source, owner) if own else (owner, result_objects.find(owner))
    if source and result and result.type == curve.TYPE:
        result.data.bevel_depth = settings.bevel_depth * meshes.diagonal(source.data)
