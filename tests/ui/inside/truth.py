# SPDX-License-Identifier: GPL-3.0-or-later
"""What the mesh has to carry, found without the add-on: weights one by one, and the library called directly."""

from typing import Any

import bpy
import numpy as np
from dirichlet_isolines import dirichlet_surface
from dirichlet_isolines.blender.names import FIELD
from numpy.typing import NDArray
from scene import colors_of, field_of, library_mesh


def fresh_field(obj: bpy.types.Object) -> NDArray[np.float32]:
    """(V,) a new solve of the object's patches as they are painted now."""
    settings = obj.dirichlet
    patches = [
        dirichlet_surface.Patch(patch.group, _painted(obj, patch.group, settings.threshold), patch.value)
        for patch in settings.patches
        if patch.enabled
    ]
    painting = dirichlet_surface.combine_patches(patches, len(obj.data.vertices), settings.overlap)
    mesh = library_mesh(dirichlet_surface, obj)
    return dirichlet_surface.solve(mesh, painting.vertices, painting.values).values.astype(np.float32)


def is_fresh(obj: bpy.types.Object) -> bool:
    """Whether the stored field is that of the paint, bit for bit."""
    expected = fresh_field(obj)
    return FIELD in obj.data.attributes and np.array_equal(field_of(obj), expected, equal_nan=True)


def colors_follow(obj: bpy.types.Object) -> bool:
    """Whether the stored colours are those of the stored field, through the ramp as Blender evaluates it, to within
    what a table of it may be off."""
    values = field_of(obj)
    defined = np.flatnonzero(np.isfinite(values))
    ramp = next(node for node in obj.active_material.node_tree.nodes if node.type == "VALTORGB").color_ramp
    some = defined[np.linspace(0, len(defined) - 1, 200).astype(int)]
    width = np.nanmax(values) - np.nanmin(values)
    places = (values[some] - np.nanmin(values)) / width if width else np.full(200, 0.5)
    expected = np.array([ramp.evaluate(place) for place in places.tolist()])
    return bool(np.abs(colors_of(obj)[some] - expected).max() < 0.01)


def lines_follow(obj: bpy.types.Object, preview: Any) -> bool:
    """Whether what is previewed, and the result that follows, are lines of the stored field at the levels that the
    settings name; preview: a Preview, or nothing."""
    levels = _levels(obj.dirichlet, field_of(obj))
    if levels is None:  # none can be had: then nothing is previewed, and the result keeps what it had
        return preview is None
    lines = dirichlet_surface.isolines(library_mesh(dirichlet_surface, obj), field_of(obj), levels)
    result = obj.dirichlet.isolines
    drawn = result and result.parent == obj and result.users_collection
    return (not obj.dirichlet.preview or np.array_equal(preview.lines.points, lines.points)) and (
        not drawn or np.array_equal(result.data["dirichlet_length"], lines.length)
    )


def _levels(settings: bpy.types.PropertyGroup, values: NDArray[np.float32]) -> NDArray[np.float64] | None:
    """Those of the modes Even and Step; nothing where they are refused, or too many to be followed."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if low == high:
        return None
    if not settings.window_auto:
        low, high = (float(str(np.float32(end))) for end in (settings.window_low, settings.window_high))
    step, phase = (float(str(np.float32(number))) for number in (settings.step, settings.phase))
    try:
        if settings.levels_mode == "EVEN":
            return dirichlet_surface.even_levels(low, high, settings.count)
        levels = dirichlet_surface.stepped_levels(low, high, step, phase)
    except dirichlet_surface.InputError:
        return None
    return levels if len(levels) <= 2000 else None


def _painted(obj: bpy.types.Object, group: str, threshold: float) -> NDArray[np.intp]:
    """Indices of the vertices whose weight in the group is above 0 and at least the threshold, ascending."""
    number = obj.vertex_groups[group].index
    lowest = np.float32(threshold)
    found = [v.index for v in obj.data.vertices for g in v.groups if g.group == number and 0 < g.weight >= lowest]
    return np.array(found, np.intp)
