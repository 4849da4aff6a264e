# SPDX-License-Identifier: GPL-3.0-or-later
"""The legend in the viewport: what it draws, from bottom to top in the unit square."""

import importlib

import bpy
import numpy as np
import pytest
from scene import painted_grid


@pytest.fixture
def legend(addon):
    return importlib.import_module(f"{addon.__name__}.blender.look.legend_geometry")


@pytest.fixture
def sheet():
    """A field from -1 to 3."""
    obj = painted_grid()
    obj.dirichlet.patches[0].value, obj.dirichlet.patches[1].value = -1.0, 3.0
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    return obj


def heights(points):
    """Of segments that cross the bar."""
    assert points.dtype == np.float32
    assert np.array_equal(points[0::2, 1], points[1::2, 1])
    assert set(points[0::2, 0]) <= {0.0}
    assert set(points[1::2, 0]) <= {1.0}
    return points[0::2, 1]


def test_ticks_stand_at_the_levels_of_the_isolines(legend, sheet):
    sheet.dirichlet.count = 4
    assert np.allclose(heights(legend.ticks(sheet)), [0.125, 0.375, 0.625, 0.875])
    sheet.dirichlet.window_low = 1.0
    assert np.allclose(heights(legend.ticks(sheet)), [0.5625, 0.6875, 0.8125, 0.9375])


def test_ticks_are_the_levels_of_the_lines_previewed(addon, legend, sheet):
    sheet.dirichlet.preview = True
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "0, 1"
    importlib.import_module(f"{addon.__name__}.blender.live").flush()
    sheet.dirichlet.levels_list = "2"  # not previewed yet
    assert np.allclose(heights(legend.ticks(sheet)), [0.25, 0.5])


def test_levels_outside_of_the_range_have_no_tick(legend, sheet):
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "-2, 0, 1, 3.5"
    assert np.allclose(heights(legend.ticks(sheet)), [0.25, 0.5])


def test_refused_levels_have_no_tick(legend, sheet):
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "0, half"
    assert legend.ticks(sheet).shape == (0, 3)


def test_constant_field_has_a_bar_and_no_tick(legend, sheet):
    sheet.dirichlet.patches[1].value = -1.0
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert legend.ticks(sheet).shape == (0, 3)
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "-1"
    assert legend.ticks(sheet).shape == (0, 3)
    assert np.ptp(legend.bar(sheet)[1], axis=0).max() == 0


def test_bar_shows_the_ramp_that_the_user_edited(legend, sheet):
    ramp = sheet.material_slots[0].material.node_tree.nodes["Dirichlet Ramp"].color_ramp
    ramp.elements[0].color, ramp.elements[-1].color = (1, 0, 1, 1), (0, 0, 0, 1)
    points, colors = legend.bar(sheet)
    assert (points[:, 1].min(), points[:, 1].max()) == (0, 1)
    assert len(points) == len(colors)
    assert np.allclose(colors[points[:, 1] == 0], (1, 0, 1, 1))
    assert np.allclose(colors[points[:, 1] == 1], (0, 0, 0, 1))


def test_shades_cover_all_but_the_window(legend):
    triangles = legend.shades((0.25, 0.875)).reshape(-1, 3, 3)[..., :2]
    edges = triangles[:, 1:] - triangles[:, :1]
    assert np.abs(np.linalg.det(edges)).sum() / 2 == pytest.approx(0.25 + 0.125)
    inside = (triangles[..., 1] > 0.25) & (triangles[..., 1] < 0.875)
    assert not inside.any()


def test_labels_name_the_range_and_give_way_to_the_window(legend, sheet):
    assert legend.labels(sheet) == [(0.0, "-1"), (1.0, "3")]
    sheet.dirichlet.window_low, sheet.dirichlet.window_high = -0.9, 1.0
    assert legend.labels(sheet) == [(pytest.approx(0.025), "-0.9"), (pytest.approx(0.5), "1"), (1.0, "3")]


def test_listed_levels_have_no_window(legend, sheet):
    settings = sheet.dirichlet
    settings.window_low, settings.window_high = 0.0, 1.0
    assert legend.window(sheet) == pytest.approx((0.25, 0.5))
    settings.levels_mode, settings.levels_list = "LIST", "-0.5, 0.5, 2.5"
    assert legend.window(sheet) == (0, 1)
    assert legend.labels(sheet) == [(0.0, "-1"), (1.0, "3")]
    bpy.ops.dirichlet.make_isolines()
    assert list(settings.isolines.data["dirichlet_level"]) == [-0.5, 0.5, 2.5]
