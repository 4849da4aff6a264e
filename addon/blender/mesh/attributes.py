# SPDX-License-Identifier: GPL-3.0-or-later
"""The field on the mesh: two point attributes."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say
from ..names import COLOR, FIELD

_TYPES = {FIELD: "FLOAT", COLOR: "FLOAT_COLOR"}


def require_names(obj: bpy.types.Object) -> None:
    """Raises InputError when something else on the mesh goes by one of the two names, since names are shared."""
    mesh = obj.data
    for name, data_type in _TYPES.items():
        found = mesh.attributes.get(name)
        if name in obj.vertex_groups:
            what = say("a vertex group")
        elif name in mesh.uv_layers:
            what = say("a UV map")
        elif found and (found.data_type, found.domain) != (data_type, "POINT"):
            what = say("a {type} attribute per {domain}", type=found.data_type, domain=found.domain)
        else:
            continue
        raise library.load().InputError(
            say(
                "'{name}' of mesh '{mesh}' is {what}: rename it, the name is needed",
                name=name,
                mesh=mesh.name,
                what=what,
            )
        )


def write(mesh: bpy.types.Mesh, values: NDArray[np.float32], colors: NDArray[np.float32]) -> None:
    """values (V,), and colors as `write_colors` takes them."""
    if not has_field(mesh) or not np.array_equal(read_field(mesh), values, equal_nan=True):
        _require(mesh, FIELD)
        mesh.attributes[FIELD].data.foreach_set("value", values)
        mesh.update()
    write_colors(mesh, colors)


def write_colors(mesh: bpy.types.Mesh, colors: NDArray[np.float32]) -> None:
    """colors (V, 4) linear. What is there already is not written, so that a write never answers a write."""
    if np.array_equal(_read_colors(mesh), colors):
        return
    made = COLOR not in mesh.attributes
    _require(mesh, COLOR)
    mesh.attributes[COLOR].data.foreach_set("color", colors.ravel())
    mesh.update()
    if made:
        show_colors(mesh)


def show_colors(mesh: bpy.types.Mesh) -> None:
    """Makes the colours active, for display and for rendering: where the user asks for them, since another attribute
    may be what they paint on."""
    attributes = mesh.color_attributes
    attributes.active_color = attributes[COLOR]  # the name alone does nothing in Blender 3
    attributes.render_color_index = attributes.find(COLOR)


def _read_colors(mesh: bpy.types.Mesh) -> NDArray[np.float32] | None:
    found = mesh.attributes.get(COLOR)
    if found is None:
        return None
    colors = np.empty(4 * len(mesh.vertices), np.float32)
    found.data.foreach_get("color", colors)
    return colors.reshape(-1, 4)


def _require(mesh: bpy.types.Mesh, name: str) -> None:
    if name not in mesh.attributes:
        mesh.attributes.new(name, _TYPES[name], "POINT")


def has_field(mesh: bpy.types.Mesh) -> bool:
    found = mesh.attributes.get(FIELD)
    return found is not None and (found.data_type, found.domain) == ("FLOAT", "POINT")


def read_field(mesh: bpy.types.Mesh) -> NDArray[np.float32]:
    """(V,) as stored. Raises InputError when there is none."""
    if not has_field(mesh):
        raise library.load().InputError(
            say("mesh '{mesh}' has no attribute '{attribute}': run Solve Field first", mesh=mesh.name, attribute=FIELD)
        )
    values = np.empty(len(mesh.vertices), np.float32)
    mesh.attributes[FIELD].data.foreach_get("value", values)
    return values
