# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines in the viewport: what goes to the graphics card."""

import dataclasses
import importlib
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from following import settle

COLORS = np.array([(0, 0, 0, 1), (0.5, 0.5, 0.5, 1), (1, 0, 1, 0.25)], np.float32)


@pytest.fixture
def segments(addon, surface):
    return importlib.import_module(f"{addon.__name__}.blender.lines.preview_geometry").segments


@pytest.fixture
def make_handler(addon):
    return importlib.import_module(f"{addon.__name__}.ui.drawing.draw_handler").DrawHandler


def isolines(*lines):
    """Of (closed, level, points); as the library has them."""
    points = [np.reshape(points, (-1, 3)) for _, _, points in lines]
    return SimpleNamespace(
        points=np.concatenate([np.empty((0, 3)), *points]),
        offsets=np.cumsum([0, *map(len, points)]),
        closed=np.array([closed for closed, _, _ in lines], bool),
        level=np.array([level for _, level, _ in lines], np.int32),
        length=np.ones(len(lines)),
        levels=np.arange(len(COLORS)),
    )


def path(number, count):
    """Points that no other path has."""
    return [(k, number, k * k) for k in range(count)]


def test_segments_are_the_successive_points_of_every_line_once(segments):
    lines = isolines((False, 0, path(0, 4)), (True, 1, path(1, 3)), (False, 2, path(2, 2)))
    assert segments(lines, COLORS).segments.tolist() == [[0, 1], [1, 2], [2, 3], [4, 5], [5, 6], [6, 4], [7, 8]]


def test_arrays_have_the_types_that_buffers_take(segments):
    points, colors, pairs = segments(isolines((True, 0, path(0, 5))), COLORS)
    assert (points.dtype, points.shape) == (np.float32, (5, 3))
    assert (colors.dtype, colors.shape) == (np.float32, (5, 4))
    assert (pairs.dtype, pairs.shape) == (np.uint32, (5, 2))
    assert all(array.flags.c_contiguous for array in (points, colors, pairs))


def test_points_have_the_color_of_their_level_as_screens_show_it(segments):
    colors = segments(isolines((False, 2, path(0, 2)), (False, 1, path(1, 3))), COLORS).colors
    assert np.allclose(colors[:2], COLORS[2])
    assert np.allclose(colors[2:], (0.7354, 0.7354, 0.7354, 1), atol=2e-3)  # 0.5 in sRGB


def test_coinciding_points_make_no_segment(segments):
    twice = [(0, 0, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0), (1 + 1e-12, 1, 0)]
    points, _, pairs = segments(isolines((True, 0, twice), (False, 0, [(2, 2, 2)] * 3)), COLORS)
    assert points.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0]]
    assert pairs.tolist() == [[0, 1], [1, 2], [2, 0]]


def test_closed_line_of_two_points_is_one_segment(segments):
    assert segments(isolines((True, 0, path(0, 2))), COLORS).segments.tolist() == [[0, 1]]


def test_no_lines_are_no_segments(segments):
    points, colors, pairs = segments(isolines(), COLORS)
    assert points.shape == (0, 3)
    assert colors.shape == (0, 4)
    assert pairs.shape == (0, 2)


def test_lines_that_a_result_draws_as_tubes_are_known(module, live, grid_live, monkeypatch):
    geometry = module("lines.preview_geometry")
    draw = geometry.draw
    settings = grid_live.dirichlet
    settings.preview = True
    bpy.ops.dirichlet.make_isolines()
    settle(live)
    result, shown = settings.isolines, live.preview_of(grid_live).lines
    assert geometry.is_drawn_by(result, geometry.Shown(shown))
    with_a_point = dataclasses.replace(
        shown,
        points=np.concatenate((shown.points, [(9, 9, 9)] * 2)),
        offsets=np.append(shown.offsets, shown.offsets[-1] + 2),
        **{name: np.append(getattr(shown, name), getattr(shown, name)[-1:]) for name in ("closed", "level")},
        length=np.append(shown.length, 0.0),
    )
    assert geometry.is_drawn_by(result, geometry.Shown(with_a_point))  # that no tube goes along
    drawings = []
    monkeypatch.setattr(geometry, "draw", lambda *args, **named: drawings.append(draw(*args, **named)) or drawings[-1])
    redrawn = geometry.Shown(with_a_point)
    assert all(geometry.is_drawn_by(result, redrawn) for _ in range(3))
    assert len(drawings) == 1
    moved = dataclasses.replace(shown, points=shown.points + 5.0)
    assert not geometry.is_drawn_by(result, geometry.Shown(moved))
    settings.bevel_depth = 0
    assert not geometry.is_drawn_by(result, geometry.Shown(shown))
    settings.bevel_depth = 0.01
    result.dirichlet_isolines.locked, settings.count = True, 5
    settle(live)
    assert not geometry.is_drawn_by(result, geometry.Shown(live.preview_of(grid_live).lines))


def test_nothing_draws_in_background(make_handler):
    handler = make_handler(pytest.fail, "POST_VIEW")
    handler.register()
    assert handler.handle is None
    handler.unregister()


def test_drawing_that_fails_says_so_once(make_handler):
    handler = make_handler(lambda: 1 / 0, "POST_VIEW")
    with pytest.raises(ZeroDivisionError):
        handler.draw()
    handler.draw()
    handler.register()
    with pytest.raises(ZeroDivisionError):
        handler.draw()
