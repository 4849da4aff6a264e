# SPDX-License-Identifier: GPL-3.0-or-later
"""The previewed lines as pixels: where they show, where they are hidden, and what colour they have."""

import math
from collections.abc import Sequence

import bpy
import numpy as np
import scene
import screen
import steps
from mathutils import Euler
from steps import Waiting, picture, run

BALL = "Ball"
_seen: list[float] = []  # numbers of coloured pixels, by `count`


def ball() -> bpy.types.Object:
    return bpy.data.objects[BALL]


def space() -> bpy.types.SpaceView3D:
    return screen.viewport().spaces.active


def look(distance: float, perspective: str) -> None:
    """From above at a slant, and from as far as makes the ball, of radius 1, fill the picture."""
    view = space().region_3d
    view.view_perspective, view.view_distance, view.view_location = perspective, distance, (0, 0, 0)
    view.view_rotation = Euler((math.radians(60), 0, 0)).to_quaternion()


def viewport_pixels() -> np.ndarray:
    """(H, W, 3) from bottom to top, without the viewport's bars, in the picture taken last."""
    image = bpy.data.images.load(str(steps.pictures / "looked.png"), check_existing=False)
    pixels = np.array(image.pixels[:], np.float32).reshape(*reversed(image.size), 4)
    bpy.data.images.remove(image)
    view = screen.region("WINDOW")
    return pixels[view.y : view.y + view.height - 60, view.x : view.x + view.width, :3]


def colored() -> np.ndarray:
    """(N, 3) the pixels that are neither black, white nor grey."""
    seen = viewport_pixels().reshape(-1, 3)
    return seen[np.ptp(seen, axis=1) > 0.3]


def count() -> Waiting:
    """Adds the number of coloured pixels to the list of what was seen."""
    yield 0.6
    yield from picture("looked")
    _seen.append(float(len(colored())))


def start() -> Waiting:
    """A white ball without shading, and nothing beside it."""
    bpy.ops.object.delete()
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    scene.painted_sphere(5, BALL)
    bpy.ops.dirichlet.solve_field()
    ball().dirichlet.count, ball().dirichlet.preview_width = 7, 4
    ball().select_set(False)
    view = space()
    view.shading.light, view.shading.color_type = "FLAT", "SINGLE"
    view.shading.single_color = (1, 1, 1)
    view.show_gizmo = view.show_region_toolbar = view.show_region_ui = False
    for name in ("show_floor", "show_axis_x", "show_axis_y", "show_cursor", "show_text", "show_object_origins"):
        setattr(view.overlay, name, False)
    look(4, "ORTHO")
    yield from count()
    assert _seen == [0]


def lines_show_where_no_surface_hides_them() -> Waiting:
    ball().dirichlet.preview = True
    yield from count()
    ball().dirichlet.preview_xray = True
    yield from count()
    ball().dirichlet.preview_xray = False
    front, all_around = _seen[-2:]
    assert front > 5000
    assert 1.3 * front < all_around < 2.5 * front


def lines_are_whole_at_every_size_and_in_perspective() -> Waiting:
    """A surface that shone through would take pixels from them; where the depth buffer is coarse, seen from clip ends
    so far away, a little more of them may peep over the ball's rim."""
    ball().dirichlet.preview_width = 1
    for perspective in ("ORTHO", "PERSP"):
        for size in (1, 1e-3, 300):
            ball().scale = (size, size, size)
            space().clip_start, space().clip_end = min(0.01, size / 10), max(1000, size * 20)
            look(4 * size, perspective)
            yield from count()
        assert all(0.98 * _seen[-3] < seen < 1.2 * _seen[-3] for seen in _seen[-2:]), _seen
    ball().scale = (1, 1, 1)
    look(4, "ORTHO")


def lines_have_the_color_of_their_level() -> Waiting:
    settings = ball().dirichlet
    settings.levels_mode, settings.levels_list, settings.preview_width = "LIST", "0.25", 16
    yield from count()
    ramp = ball().active_material.node_tree.nodes["Dirichlet Ramp"].color_ramp
    assert np.abs(np.median(colored(), axis=0) - on_screen(ramp.evaluate(0.25))).max() < 0.02


def lines_go_with_the_object_and_the_overlays() -> Waiting:
    shown = _seen[-1]
    for owner, name, off in (
        (space().overlay, "show_overlays", False),
        (ball(), "hide_viewport", True),
        (space(), "show_object_viewport_mesh", False),
        (ball().dirichlet, "preview", False),
    ):
        setattr(owner, name, off)
        yield from count()
        setattr(owner, name, not off)
        yield from count()
        assert _seen[-2:] == [0, shown], name


def lines_show_in_every_mode() -> Waiting:
    space().overlay.weight_paint_mode_opacity = 0
    shown = _seen[-1]
    for mode in ("WEIGHT_PAINT", "VERTEX_PAINT", "EDIT", "OBJECT"):
        bpy.ops.object.mode_set(mode=mode)
        yield from count()
        assert _seen[-1] > 0.5 * shown, mode


def lines_that_a_result_shows_are_drawn_once() -> Waiting:
    """The tubes have no colours in this shading; the preview's lines have, and are seen where the tubes are not."""
    shown = _seen[-1]
    with screen.at():
        bpy.ops.dirichlet.make_isolines()
    yield from count()
    assert _seen[-1] == 0
    ball().dirichlet.preview_xray = True
    yield from count()
    assert _seen[-1] > shown
    ball().dirichlet.preview_xray = False
    ball().dirichlet.isolines.hide_set(True)
    yield from count()
    assert _seen[-1] > 0.5 * shown
    bpy.data.objects.remove(ball().dirichlet.isolines)


def the_legend_has_ramp_window_and_levels() -> Waiting:
    """Read from the picture: a bar of saturated colours, dark where the window ends and at the levels."""
    settings = ball().dirichlet
    settings.preview, settings.legend, settings.levels_mode, settings.count = False, True, "EVEN", 4
    yield from count()
    bar = legend_bar()
    height = len(bar)
    assert abs(height - 280 * bpy.context.preferences.system.ui_scale) < 4
    ramp = ball().active_material.node_tree.nodes["Dirichlet Ramp"].color_ramp
    for place in (0.02, 0.25, 0.6, 0.75, 0.98):  # between the levels, and not at the kink in the middle
        assert off(bar, place, on_screen(ramp.evaluate(place))) < 0.03, place
    for level in (0.125, 0.375, 0.625, 0.875):
        assert off(bar, level, (0, 0, 0)) < 0.1, level
    settings.window_low = 0.5
    yield from count()
    shaded = legend_bar(height)
    for place, light in ((0.25, 0.4), (0.98, 1)):  # six tenths of black lie over what is outside of the window
        assert off(shaded, place, on_screen(light * np.array(ramp.evaluate(place)))) < 0.03, place
    settings.legend = False
    yield from count()
    assert _seen[-1] == 0


def legend_bar(height: int = 0) -> np.ndarray:
    """(H, 3) the colours up the middle of the legend's bar, in the picture taken last; its height where that is known,
    since what is shaded has less colour."""
    seen = viewport_pixels()
    rows, columns = np.nonzero(np.ptp(seen, axis=2) > 0.3)
    top = rows.max() + 1
    return seen[top - height if height else rows.min() : top, (columns.min() + columns.max()) // 2]


def off(bar: np.ndarray, place: float, color: Sequence[float]) -> float:
    """How much the bar differs from the color at a place from 0 to 1, give or take two pixels."""
    middle = round(place * (len(bar) - 1))
    return float(np.abs(bar[middle - 2 : middle + 3] - color).max(axis=1).min())


def on_screen(color: Sequence[float]) -> np.ndarray:
    """sRGB of a linear color."""
    linear = np.array(color[:3])
    return np.where(linear < 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


run(
    start,
    lines_show_where_no_surface_hides_them,
    lines_are_whole_at_every_size_and_in_perspective,
    lines_have_the_color_of_their_level,
    lines_go_with_the_object_and_the_overlays,
    lines_show_in_every_mode,
    lines_that_a_result_shows_are_drawn_once,
    the_legend_has_ramp_window_and_levels,
)
