# SPDX-License-Identifier: GPL-3.0-or-later
"""An artist's first ten minutes: two patches painted, the field live under the brush, a window on the ramp, undo."""

import bpy
import hand
import numpy as np
import screen
from canvas import add_ball, ball, go_to, stroke
from dirichlet_isolines.blender import live
from dirichlet_isolines.blender.mesh.sessions import open_session
from scene import field_of
from steps import Waiting, pictures, run, until
from truth import colors_follow, is_fresh


def start() -> Waiting:
    yield from add_ball()


def open_the_tab() -> Waiting:
    yield from hand.move(screen.pixel_of((0, 0, 0)))
    yield from hand.press("n")
    yield from screen.open_tab(bpy.types.DIRICHLET_PT_patches)


def paint_the_first_patch() -> Waiting:
    go_to("WEIGHT_PAINT")
    yield 1
    yield from stroke((-0.7, -0.3), (-0.7, 0.3))
    yield from screen.press("patch_add_group", 0.8)


def paint_the_second_patch() -> Waiting:
    bpy.ops.object.vertex_group_add()
    yield from stroke((0.6, -0.3), (0.6, 0.3))
    yield from screen.press("patch_add_group", 0.8)


def solve() -> Waiting:
    yield from screen.press("solve_field", 0.2)
    yield from screen.press("make_isolines")
    _assert_current()


def switch_live_on() -> Waiting:
    yield from screen.press("live")
    yield from screen.press("preview", 0.22, 0.17)
    yield from until(_is_quiet)
    assert ball().dirichlet.live
    assert live.preview_of(ball())
    screen.viewport().spaces.active.overlay.weight_paint_mode_opacity = 0.4


def paint_on() -> Waiting:
    ball().vertex_groups.active_index = 0
    yield from _followed_stroke((-0.3, -0.6), (-0.7, -0.2))
    yield from _followed_stroke((-0.3, 0.6), (-0.7, 0.2))


def slide_the_window() -> Waiting:
    """Lines follow while the mouse still moves, and nothing is factored or solved anew."""
    solver, field, shown = open_session(ball())._solver, field_of(ball()), []
    assert solver
    x, y = yield from screen.find("window_low_place", 0.2)
    for seconds in hand.drag(hand.line((x, y), (x + 70, y)), 0.4):
        shown.append(live.preview_of(ball()).version)
        yield seconds
    yield from until(_is_quiet)
    settings = ball().dirichlet
    assert len(set(shown)) > 2
    assert 0.2 < settings.window_low == settings.window_low_place < 0.9
    assert settings.window_high == settings.window_high_place == 1
    levels = live.preview_of(ball()).lines.levels
    assert len(levels) == settings.count
    assert settings.window_low < levels.min() < levels.max() < settings.window_high
    assert open_session(ball())._solver is solver
    assert solver.report.update == "nothing"
    assert np.array_equal(field_of(ball()), field)
    _assert_current()


def undo_twice() -> Waiting:
    painted = field_of(ball())
    yield from hand.move(screen.pixel_of((0, 0, 0)))
    for _ in range(2):
        yield from _undo()
        if np.array_equal(field_of(ball()), painted):  # the slider's step, which later Blenders have
            yield from _undo()
        assert ball().dirichlet.live
        assert not np.array_equal(field_of(ball()), painted)
        painted = field_of(ball())


def redo() -> Waiting:
    yield from hand.press("ctrl+shift+z")
    yield from until(_is_quiet)
    _assert_current()


def save_and_load() -> Waiting:
    file, before = str(pictures / "painted.blend"), field_of(ball())
    with screen.at():
        bpy.ops.wm.save_as_mainfile(filepath=file)
        bpy.ops.wm.open_mainfile(filepath=file)
    yield 1
    yield from until(_is_quiet)
    assert np.array_equal(field_of(ball()), before)
    _assert_current()
    yield from _followed_stroke((0.2, 0.6), (0.6, 0.5))


def _followed_stroke(start: tuple[float, float], end: tuple[float, float]) -> Waiting:
    field, version = field_of(ball()), live.preview_of(ball()).version
    yield from stroke(start, end)
    yield from until(_is_quiet)
    _assert_current()
    assert not np.array_equal(field_of(ball()), field)
    assert live.preview_of(ball()).version > version


def _undo() -> Waiting:
    yield from hand.press("ctrl+z")
    yield from until(_is_quiet)
    _assert_current()


def _is_quiet() -> bool:
    return not live.is_pending(ball())


def _assert_current() -> None:
    """Field, colours and lines are those of the paint."""
    assert is_fresh(ball())
    assert colors_follow(ball())
    assert len(ball().dirichlet.isolines.data.splines) == ball().dirichlet.results.lines > 0


run(
    start,
    open_the_tab,
    paint_the_first_patch,
    paint_the_second_patch,
    solve,
    switch_live_on,
    paint_on,
    slide_the_window,
    undo_twice,
    redo,
    save_and_load,
)
