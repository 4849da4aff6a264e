# SPDX-License-Identifier: GPL-3.0-or-later
"""What is painted on, seen from the front, and how it is painted with the mouse."""

import math

import bpy
import hand
import screen
from steps import Waiting


def ball() -> bpy.types.Object:
    """The only mesh object. Asked for anew every time: undo and files replace it."""
    return next(obj for obj in bpy.data.objects if obj.type == "MESH")


def add_ball() -> Waiting:
    """10242 vertices, radius 1, alone in the file."""
    _clear()
    with screen.at():
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6)
    yield from _look_at_it()


def add_sheet(vertices: int) -> Waiting:
    """A square of about so many vertices, 2 wide, upright and alone in the file."""
    _clear()
    side = math.isqrt(vertices) - 1
    with screen.at():
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=side, y_subdivisions=side, rotation=(math.pi / 2, 0, 0))
    yield from _look_at_it()


def stroke(start: tuple[float, float], end: tuple[float, float]) -> Waiting:
    """A real one between two points of the front, given by the world's x and z."""
    yield from hand.drag(hand.line(*(screen.pixel_of((x, 0, z)) for x, z in (start, end))))


def paint_with(weight: float) -> None:
    tools = bpy.context.scene.tool_settings
    holder = tools.weight_paint if bpy.app.version >= (5, 0, 0) else tools  # weight_paint is None before its first use
    if holder:
        holder.unified_paint_settings.weight = weight


def go_to(mode: str) -> None:
    with screen.at():
        bpy.context.view_layer.objects.active = ball()
        bpy.ops.object.mode_set(mode=mode)


def _clear() -> None:
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)


def _look_at_it() -> Waiting:
    with screen.at():
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_selected()
    paint_with(1)
    yield 1
