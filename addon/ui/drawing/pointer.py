# SPDX-License-Identifier: GPL-3.0-or-later
"""The mouse pointer over the active object's surface."""

from __future__ import annotations

import bpy
from bpy_extras import view3d_utils
from mathutils import Vector


class Pointer:
    """Where the mouse is in a 3D viewport, which stays the same for a drag."""

    def __init__(self, area: bpy.types.Area, region: bpy.types.Region, event: bpy.types.Event) -> None:
        self.area, self.region = area, region
        self.view = region.data
        self.move(event)

    def move(self, event: bpy.types.Event) -> None:
        self.place = Vector((event.mouse_x - self.region.x, event.mouse_y - self.region.y))

    def hit(self, context: bpy.types.Context):
        """The blender.picking.Hit of the active object below the pointer, if it has one there."""
        from ...blender.mesh import picking

        origin = view3d_utils.region_2d_to_origin_3d(self.region, self.view, self.place)
        direction = view3d_utils.region_2d_to_vector_3d(self.region, self.view, self.place)
        return picking.cast_ray(context.active_object, context.evaluated_depsgraph_get(), origin, direction)

    def at_depth_of(self, point: Vector) -> Vector:
        """The point in world space that the pointer is at, as far away as another."""
        return view3d_utils.region_2d_to_location_3d(self.region, self.view, self.place, point)


def find(context: bpy.types.Context, event: bpy.types.Event) -> Pointer | None:
    """In the viewport under the mouse, not in its bars; None elsewhere."""
    for area in context.screen.areas:
        if area.type == "VIEW_3D":
            regions = {region.type: region for region in area.regions if _inside(region, event)}
            if set(regions) == {"WINDOW"}:
                return Pointer(area, regions["WINDOW"], event)
    return None


def _inside(region: bpy.types.Region, event: bpy.types.Event) -> bool:
    return 0 <= event.mouse_x - region.x < region.width and 0 <= event.mouse_y - region.y < region.height
