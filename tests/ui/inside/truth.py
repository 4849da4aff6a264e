# SPDX-License-Identifier: GPL-3.0-or-later
"""What the mesh has to carry, found without the add-on: weights one by one, and the library called directly."""

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
    ramp = next(node for node in obj.active_material.node_tree.nodes if node.type == "VALTORGB").color_ramp
    some = np.linspace(0, len(values) - 1, 200).astype(int)
    places = (values[some] - values.min()) / np.ptp(values)
    expected = np.array([ramp.evaluate(place) for place in places.tolist()])
    return bool(np.abs(colors_of(obj)[some] - expected).max() < 0.01)


def _painted(obj: bpy.types.Object, group: str, threshold: float) -> NDArray[np.intp]:
    """Indices of the vertices whose weight in the group is above 0 and at least the threshold, ascending."""
    number = obj.vertex_groups[group].index
    lowest = np.float32(threshold)
    found = [v.index for v in obj.data.vertices for g in v.groups if g.group == number and 0 < g.weight >= lowest]
    return np.array(found, np.intp)
