# SPDX-License-Identifier: GPL-3.0-or-later
"""An artist's first ten minutes: two patches painted, the field live under the brush, a window on the ramp, undo."""

import bpy
import hand
import screen
from steps import Waiting, run
from truth import colors_follow, is_fresh

BALL = "Icosphere"


def ball() -> bpy.types.Object:
    """Asked for anew in every step: undo and files replace it."""
    return bpy.data.objects[BALL]


def stroke(start: tuple[float, float], end: tuple[float, float]) -> Waiting:
    """From one direction to another, both as x and z of the ball's front."""
    ends = [(x, -((1 - x * x - z * z) ** 0.5), z) for x, z in (start, end)]
    yield from hand.drag(hand.line(*(screen.pixel_of(ball(), end) for end in ends)))


def press_button(name: str, across: float = 0.6) -> Waiting:
    yield from hand.click((yield from screen.find(name, across)))


def start() -> Waiting:
    bpy.ops.object.delete()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6)
    yield 0.5
    with screen.at():
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_selected()
    yield 1


def open_the_tab() -> Waiting:
    yield from hand.move(screen.pixel_of(ball(), (0, 0, 0)))
    yield from hand.press("n")
    yield from screen.open_tab(bpy.types.DIRICHLET_PT_patches)


def paint_the_first_patch() -> Waiting:
    bpy.ops.object.mode_set(mode="WEIGHT_PAINT")
    bpy.context.scene.tool_settings.unified_paint_settings.weight = 1
    yield 1
    yield from stroke((-0.7, -0.3), (-0.7, 0.3))
    yield from press_button("patch_add_group", 0.8)


def paint_the_second_patch() -> Waiting:
    bpy.ops.object.vertex_group_add()
    yield from stroke((0.6, -0.3), (0.6, 0.3))
    yield from press_button("patch_add_group", 0.8)


def solve() -> Waiting:
    yield from press_button("solve_field")
    yield from press_button("make_isolines")
    assert is_fresh(ball())
    assert colors_follow(ball())
    assert len(ball().dirichlet.isolines.data.splines) == ball().dirichlet.results.lines > 0


run(start, open_the_tab, paint_the_first_patch, paint_the_second_patch, solve)
