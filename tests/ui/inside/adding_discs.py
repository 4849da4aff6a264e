# SPDX-License-Identifier: GPL-3.0-or-later
"""The Add Patch tool in an artist's hand: press, drag, release, change of mind, undo; and a picked level."""

import bpy
import hand
import numpy as np
import screen
import steps
from canvas import add_ball, ball
from hand import Pixel
from mathutils import Vector
from steps import Waiting, finished, picture, run, until
from truth import is_fresh

LEFT, RIGHT = (-0.5, -(0.75**0.5), 0.0), (0.5, -(0.75**0.5), 0.0)  # on the front of the ball
FINE = 0.03  # some edges of the mesh


def patches() -> list[tuple[str, float]]:
    return [(patch.group, patch.value) for patch in ball().dirichlet.patches]


def members(group: str) -> set[int]:
    obj = ball()
    index = obj.vertex_groups[group].index
    return {v.index for v in obj.data.vertices if any(g.group == index and g.weight == 1 for g in v.groups)}


def pixel(point: tuple[float, float, float], right: int = 0) -> Pixel:
    x, y = screen.pixel_of(point)
    return x + right, y


def pixels_near(name: str, x: int, y: int) -> np.ndarray:
    """(60, 160, 3) of a picture, around a pixel."""
    image = bpy.data.images.load(str(steps.pictures / f"{name}.png"))
    pixels = np.array(image.pixels[:], np.float32).reshape(*reversed(image.size), 4)[::-1, :, :3]
    bpy.data.images.remove(image)
    return pixels[y - 30 : y + 30, x - 80 : x + 80]


def take_the_tool() -> None:
    with screen.at():
        bpy.ops.wm.tool_set_by_id(name="dirichlet.add_patch")


def press_and_drag(point: tuple[float, float, float], right: int) -> Waiting:
    yield from finished("xdotool", "mousemove", *pixel(point), "sleep", 0.2, "mousedown", 1, "sleep", 0.2)
    for k in range(1, 6):
        yield from finished("xdotool", "mousemove", *pixel(point, right * k // 5), "sleep", 0.1)
    yield 0.4


def start() -> Waiting:
    yield from add_ball()
    take_the_tool()
    bpy.ops.ed.undo_push(message="start")
    yield 1


def drag_a_disc() -> Waiting:
    yield from press_and_drag(LEFT, 60)
    assert not patches()  # nothing before the button is let go
    yield from picture("while-dragging")
    yield from finished("xdotool", "mouseup", 1)
    yield from until(lambda: patches() == [("Disc", 0)])
    obj = ball()
    inside = members("Disc")
    pressed = Vector(bpy.context.window_manager.operators[-1].location)
    assert (pressed - Vector(LEFT)).length < FINE  # pixels are whole
    straight = [(vertex.co - pressed).length for vertex in obj.data.vertices]
    dragged = obj.dirichlet.disc_radius
    assert 0.1 < dragged < 0.8
    assert max(straight[k] for k in inside) <= dragged
    assert {k for k, distance in enumerate(straight) if distance < 0.9 * dragged} <= inside


def change_of_mind() -> Waiting:
    before = patches(), ball().dirichlet.disc_radius
    yield from press_and_drag(RIGHT, 100)
    yield from finished("xdotool", "click", 3)  # not Esc, after which Blender ends with exit code 1
    yield from finished("xdotool", "mouseup", 1)
    yield 0.3
    assert (patches(), ball().dirichlet.disc_radius) == before


def beside_the_ball() -> Waiting:
    x, y = pixel((-1, 0, 0))[0] - 90, pixel(LEFT)[1]
    yield from hand.move((x, y))
    yield from picture("before-the-click")
    yield from hand.click((x, y))
    yield from picture("said-at-the-pointer")
    assert patches() == [("Disc", 0)]
    before, after = (pixels_near(name, x, y) for name in ("before-the-click", "said-at-the-pointer"))
    assert np.any(before != after, axis=2).mean() > 0.2
    yield from hand.press("Escape")  # which takes the message away
    yield 1


def a_click_takes_the_last_radius_while_painting() -> Waiting:
    bpy.ops.object.mode_set(mode="WEIGHT_PAINT")
    take_the_tool()
    yield 0.5
    yield from hand.click(pixel(RIGHT))
    yield from until(lambda: patches() == [("Disc", 0), ("Disc.001", 1)])
    assert abs(len(members("Disc")) / len(members("Disc.001")) - 1) < FINE * 3
    assert bpy.context.mode == "PAINT_WEIGHT"


def undo_and_redo() -> Waiting:
    yield from hand.press("ctrl+z")
    yield from until(lambda: patches() == [("Disc", 0)])
    yield from hand.press("ctrl+shift+z")
    yield from until(lambda: patches() == [("Disc", 0), ("Disc.001", 1)])


def pick_a_level() -> Waiting:
    bpy.ops.dirichlet.solve_field()
    assert is_fresh(ball())
    with screen.at():
        bpy.ops.dirichlet.pick_level("INVOKE_DEFAULT")
    yield from hand.click(pixel((0.0, -1.0, 0.0)))
    settings = ball().dirichlet
    *even, picked = map(float, settings.levels_list.split(","))
    assert settings.levels_mode == "LIST"
    assert len(even) == settings.count
    assert abs(picked - 0.5) < FINE  # midway between two discs alike


run(
    start,
    drag_a_disc,
    change_of_mind,
    beside_the_ball,
    a_click_takes_the_last_radius_while_painting,
    undo_and_redo,
    pick_a_level,
)
