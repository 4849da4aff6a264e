# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to choose levels."""

import numpy as np
import pytest
from dirichlet_surface import InputError, even_levels, isolines, level_through_point, solve, stepped_levels
from mesh_makers import grid, joined, sphere
from numpy.testing import assert_allclose, assert_array_equal


@pytest.mark.parametrize("count", [1, 2, 13, 1000])
def test_even_levels_are_the_middles_of_equal_parts_of_the_window(count):
    levels = even_levels(-1.5, 2.5, count)
    assert levels.dtype == np.float64
    assert_allclose(levels, -1.5 + (np.arange(count) + 0.5) * 4 / count, rtol=0, atol=1e-15 * 4)


@pytest.mark.parametrize(("low", "high"), [(0, 5e-324 * 64), (-1.7e308, 1.7e308), (1e6, 1e6 + 1e-6), (-1e-300, 1e-300)])
def test_even_levels_stay_inside_any_window(low, high):
    levels = even_levels(low, high, 7)
    assert levels.shape == (7,)
    assert (np.diff(levels) > 0).all()
    assert low < levels[0]
    assert levels[-1] < high


@pytest.mark.parametrize(
    ("low", "high", "count"), [(0, 1, 0), (0, 1, -1), (1, 1, 3), (1, 0, 3), (np.nan, 1, 3), (0, np.inf, 3)]
)
def test_even_levels_refuse_an_empty_window_or_no_levels(low, high, count):
    with pytest.raises(InputError):
        even_levels(low, high, count)


def test_stepped_levels_are_multiples_of_the_step_strictly_inside():
    assert_array_equal(stepped_levels(-0.5, 1.0, 0.25), [-0.25, 0, 0.25, 0.5, 0.75])


@pytest.mark.parametrize("phase", [0.0, 0.25, 0.5, -0.75, 3.25])
def test_the_phase_moves_stepped_levels_by_parts_of_a_step(phase):
    levels = stepped_levels(0.0, 10.0, 2.0, phase)
    assert_allclose(np.diff(levels), 2)
    assert_allclose(levels / 2 % 1, phase % 1, atol=1e-12)
    assert levels[0] <= 2
    assert levels[-1] >= 8


def test_a_whole_phase_changes_nothing():
    assert_allclose(stepped_levels(0, 1, 0.125, 1.0), stepped_levels(0, 1, 0.125))


@pytest.mark.parametrize(
    ("low", "high", "step", "phase"),
    [(0, 1, 0, 0), (0, 1, -1, 0), (0, 1, np.nan, 0), (0, 1, 0.1, np.inf), (1, 0, 0.1, 0), (0, 1, 1e-9, 0)],
)
def test_stepped_levels_refuse_what_is_no_step_and_what_is_too_much(low, high, step, phase):
    with pytest.raises(InputError):
        stepped_levels(low, high, step, phase)


def test_the_level_through_a_vertex_is_its_value():
    soup = sphere(9, 12)
    values = np.random.default_rng(0).normal(size=soup.size)
    assert level_through_point(soup.mesh(), values, soup.positions[33]) == values[33]


@pytest.mark.parametrize("triangles", [True, False])
def test_the_level_through_a_point_of_a_linear_field_is_its_value_there(triangles):
    soup = grid(6, 4, triangles)
    values = soup.positions @ [2.0, -1.0, 0.0]
    assert level_through_point(soup.mesh(), values, [2.3, 1.9, 5.0]) == pytest.approx(2.7)  # 5 above the surface
    assert level_through_point(soup.mesh(), values, [-3, 9, 0]) == pytest.approx(-4)  # off a corner


def test_the_line_at_that_level_runs_through_the_point():
    soup = sphere(9, 12)
    mesh, values = soup.mesh(), solve(soup.mesh(), [0, 109], [0.0, 1.0]).values
    point = soup.positions[soup.faces[100]].mean(axis=0)
    lines = isolines(mesh, values, [level_through_point(mesh, values, point)])
    start, end = lines.points, np.roll(lines.points, -1, axis=0)
    along = np.clip(((point - start) * (end - start)).sum(1) / ((end - start) ** 2).sum(1), 0, 1)
    assert np.linalg.norm(start + along[:, None] * (end - start) - point, axis=1).min() < 1e-12


@pytest.mark.parametrize("point", [[np.nan, 0, 0], [0, 0], [0, 0, np.inf]])
def test_a_point_that_is_no_point_is_refused(point):
    with pytest.raises(InputError):
        level_through_point(sphere(5, 7).mesh(), np.zeros(37), point)


def test_a_point_where_the_field_is_undefined_is_refused():
    soup = joined(grid(2, 2), grid(2, 2))
    values = solve(soup.mesh(), [0, 1], [0.0, 1.0]).values
    with pytest.raises(InputError):
        level_through_point(soup.mesh(), values, [11, 1, 0])


@pytest.mark.parametrize("count", [0, -1, 2.5, "3", 10**10])
def test_a_number_of_levels_that_is_none_is_refused(count):
    with pytest.raises(InputError, match="the number of levels"):
        even_levels(0, 1, count)
