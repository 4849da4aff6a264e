# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of an object's surface, as it is shown, under a ray."""

from __future__ import annotations

from typing import NamedTuple

import bpy
from mathutils import Vector
from mathutils.interpolate import poly_3d_calc


class Hit(NamedTuple):
    shown: Vector  # in world space, on the surface as modifiers and shape keys show it
    location: Vector  # in object space, at the same place of the mesh data-block; where modifiers added or removed
    # faces there is no such place: then as shown, and the mesh's nearest point stands for it
    face: int | None  # polygon of the mesh data-block with that place


def cast_ray(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph, origin: Vector, direction: Vector) -> Hit | None:
    """The first point of the object's surface on a ray in world space; other objects do not stand in the way. A hidden
    object has none."""
    if not obj.visible_get():
        return None
    shown = obj.evaluated_get(depsgraph)
    inverse = obj.matrix_world.inverted_safe()
    found, location, _, face = shown.ray_cast(inverse @ origin, inverse.to_3x3() @ direction, depsgraph=depsgraph)
    if not found:
        return None
    world = obj.matrix_world @ location
    if not _same_polygon(shown.data, obj.data, face):
        return Hit(world, location, None)
    corners = obj.data.polygons[face].vertices
    weights = poly_3d_calc([shown.data.vertices[corner].co for corner in corners], location)
    places = (obj.data.vertices[corner].co * weight for corner, weight in zip(corners, weights))
    return Hit(world, sum(places, Vector()), face)


def _same_polygon(shown: bpy.types.Mesh, mesh: bpy.types.Mesh, face: int) -> bool:
    """Whether modifiers left the faces alone, as far as counts and this one tell."""
    counts = ((len(found.vertices), len(found.loops), len(found.polygons)) for found in (shown, mesh))
    return len(set(counts)) == 1 and shown.polygons[face].vertices[:] == mesh.polygons[face].vertices[:]
