# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines without short ones, smoothed, resampled, simplified, thicker by level; and in the same order every time."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import field_of, library_mesh, painted_grid

OUTPUTS = ["CURVE", "MESH", *(["CURVES"] if "set_types" in bpy.types.Curves.bl_rna.functions else [])]


def make(obj):
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    return obj.dirichlet.isolines.data


def lines_of(curve):
    return [np.array([point.co[:3] for point in spline.points]) for spline in curve.splines]


def segments(line, closed):
    return np.linalg.norm(np.diff(line, axis=0, append=line[:1] if closed else line[:0]), axis=1)


def diagonal(obj):
    return np.linalg.norm(np.ptp([vertex.co for vertex in obj.data.vertices], axis=0))


def test_lines_shorter_than_the_shortest_are_left_out(sphere):
    before = list(make(sphere)["dirichlet_length"])
    limit = np.median(before)
    sphere.dirichlet.min_length = limit / diagonal(sphere)
    kept = list(make(sphere)["dirichlet_length"])
    assert kept == [length for length in before if length >= sphere.dirichlet.min_length * diagonal(sphere)]
    assert 0 < len(kept) < len(before)


def test_resampled_lines_have_even_segments(sphere):
    sphere.dirichlet.resample = 0.05
    for line in lines_of(make(sphere)):
        lengths = segments(line, closed=True)
        assert lengths.max() < 1.1 * lengths.min()  # even along the line, whose corners they cut
        assert lengths.mean() == pytest.approx(0.05 * diagonal(sphere), rel=0.2)


def test_simplified_lines_have_fewer_points_within_the_tolerance(sphere):
    before = lines_of(make(sphere))
    sphere.dirichlet.simplify = 0.01
    after = lines_of(make(sphere))
    for many, few in zip(before, after, strict=True):
        assert 3 <= len(few) < len(many)
        starts, ends = few, np.roll(few, -1, axis=0)
        along = ends - starts
        places = np.einsum("psk,sk->ps", many[:, None] - starts, along) / (along**2).sum(axis=1)
        nearest = starts + np.clip(places, 0, 1)[..., None] * along
        assert np.linalg.norm(many[:, None] - nearest, axis=2).min(axis=1).max() <= 0.01 * diagonal(sphere) + 1e-5


def test_smoothed_lines_are_the_librarys_and_shorter(sphere, surface):
    before = sum(make(sphere)["dirichlet_length"])
    sphere.dirichlet.smooth = 8
    curve = make(sphere)
    mesh, values = library_mesh(surface, sphere), field_of(sphere)
    lines = surface.smooth_lines(mesh, surface.isolines(mesh, values, surface.even_levels(0, 1, 13)), 8)
    assert np.allclose(np.concatenate(lines_of(curve)), lines.points, atol=1e-6)
    assert sum(curve["dirichlet_length"]) < before


def test_all_options_together_come_in_their_order(sphere, surface):
    settings, size = sphere.dirichlet, diagonal(sphere)
    settings.min_length, settings.smooth, settings.resample, settings.simplify = 1.0, 3, 0.03, 0.002
    mesh = library_mesh(surface, sphere)
    lines = surface.isolines(mesh, field_of(sphere), surface.even_levels(0, 1, 13))
    lines = surface.smooth_lines(mesh, surface.keep_long(lines, 1.0 * size), 3)
    lines = surface.simplify_lines(surface.resample_lines(lines, 0.03 * size), 0.002 * size)
    drawn = lines_of(make(sphere))
    assert [len(line) for line in drawn] == np.diff(lines.offsets).tolist()
    assert np.allclose(np.concatenate(drawn), lines.points, atol=1e-5)


@pytest.mark.parametrize("output", OUTPUTS)
def test_thickness_changes_evenly_over_the_window(sheet, output):
    settings = sheet.dirichlet
    settings.output, settings.levels_mode, settings.step = output, "STEP", 0.25
    settings.bevel_low, settings.bevel_high = 1.0, 3.0
    settings.window_low, settings.window_high = 0.125, 0.625  # the levels are at 1/4 and 3/4 of it
    data = make(sheet)
    if output == "CURVE":
        radii = [point.radius for spline in data.splines for point in spline.points]
    else:
        radii = [item.value / (0.002 * diagonal(sheet)) for item in data.attributes["radius"].data]
    expected = np.repeat([1.5, 2.5], len(radii) // 2)
    assert np.allclose(radii, expected, rtol=1e-5)


def test_the_same_input_gives_the_same_lines(sphere):
    sphere.dirichlet.smooth, sphere.dirichlet.resample = 2, 0.02
    first = lines_of(make(sphere))
    bpy.ops.dirichlet.solve_field()
    assert all(map(np.array_equal, first, lines_of(make(sphere))))


def test_lines_keep_place_and_direction_when_a_value_changes_a_little(sphere):
    """One line per level whatever the values, so that line number and start have no reason to change."""
    sphere.dirichlet.levels_mode, sphere.dirichlet.levels_list = "LIST", "0.2 0.4 0.6 0.8"
    before = lines_of(make(sphere))
    sphere.dirichlet.patches[1].value = 1.001
    bpy.ops.dirichlet.solve_field()
    after = lines_of(make(sphere))
    assert len(after) == len(before) == 4
    for old, new in zip(before, after, strict=True):
        assert np.linalg.norm(old.mean(axis=0) - new.mean(axis=0)) < 0.02
        assert np.dot(turning(old), turning(new)) > 0.9


def turning(line):
    """The unit normal that a closed line runs around."""
    area = np.cross(line - line.mean(axis=0), np.roll(line, -1, axis=0) - line.mean(axis=0)).sum(axis=0)
    return area / np.linalg.norm(area)


@pytest.mark.parametrize("mode", ["EQUAL_AREA", "EQUAL_DISTANCE"])
def test_levels_are_spread_over_the_surface_inside_the_window(sphere, surface, mode):
    settings = sphere.dirichlet
    settings.levels_mode, settings.count = mode, 5
    settings.window_low, settings.window_high = 0.25, 0.75
    spread = {"EQUAL_AREA": surface.equal_area_levels, "EQUAL_DISTANCE": surface.equal_distance_levels}[mode]
    expected = spread(library_mesh(surface, sphere), field_of(sphere), 5, 0.25, 0.75)
    assert list(make(sphere)["dirichlet_level"]) == expected.tolist()
    assert not np.allclose(np.diff(expected), np.diff(expected).mean())


@pytest.mark.parametrize("mode", ["EQUAL_AREA", "EQUAL_DISTANCE"])
def test_a_constant_field_has_no_levels_to_spread(mode):
    obj = painted_grid()
    obj.dirichlet.patches[1].value = 0.0
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.levels_mode = mode
    assert_refused(bpy.ops.dirichlet.make_isolines, obj, "the field is 0 everywhere: give another patch another value")
