# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines: connected, oriented, closed where the surface is, and exact at vertices and plateaus."""

import numpy as np
import pytest
from dirichlet_surface import InputError, Mesh, even_levels, isolines, solve
from isoline_laws import assert_same_lines, assert_sound, segments
from mesh_makers import ZOO, Soup, book, grid, joined, moebius, sphere, torus
from numpy.testing import assert_allclose, assert_array_equal
from paintings import random_paint

CLOSED = {name: ZOO[name] for name in ("sphere", "torus", "Klein bottle", "prism", "tetrahedron")}
UNPINCHED = {name: soup for name, soup in ZOO.items() if name != "bow tie"}  # a level may meet that in one vertex
everywhere = pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
on_closed_surfaces = pytest.mark.parametrize("soup", CLOSED.values(), ids=CLOSED.keys())


def random_values(soup: Soup, seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=soup.size)


@everywhere
def test_lines_of_a_random_field_are_sound(soup):
    mesh, values = soup.mesh(), random_values(soup)
    assert_sound(mesh, values, isolines(mesh, values, even_levels(values.min(), values.max(), 7)))


@everywhere
def test_lines_of_a_solved_field_are_sound(soup):
    mesh = soup.mesh()
    values = solve(mesh, *random_paint(soup.size)).values
    assert_sound(mesh, values, isolines(mesh, values, even_levels(values.min(), values.max(), 7)))


@everywhere
def test_levels_at_vertex_values_give_sound_lines(soup):
    mesh, values = soup.mesh(), np.round(random_values(soup))
    assert_sound(mesh, values, isolines(mesh, values, np.unique(values)))


@on_closed_surfaces
@pytest.mark.parametrize("kind", ["random", "whole numbers"])
def test_every_line_on_a_closed_surface_is_closed(soup, kind):
    values = random_values(soup) if kind == "random" else np.round(random_values(soup))
    lines = isolines(soup.mesh(), values, [*np.unique(np.round(values)), (values.min() + values.max()) / 2])
    assert len(lines) > 0
    assert lines.closed.all()


@on_closed_surfaces
def test_points_have_even_degree_on_a_closed_surface(soup):
    values = np.round(random_values(soup))
    lines = isolines(soup.mesh(), values, np.unique(values))
    start, end = segments(lines)
    level = np.repeat(lines.level, np.diff(lines.offsets))
    ends = np.concatenate((start, end))
    _, degree = np.unique(np.column_stack((level[ends], lines.points[ends])), axis=0, return_counts=True)
    assert (degree % 2 == 0).all()


@pytest.mark.parametrize("count", [1, 2, 10, 1000])
@pytest.mark.parametrize("soup", UNPINCHED.values(), ids=UNPINCHED.keys())
def test_n_levels_give_n_levels(soup, count):
    mesh = soup.mesh()
    values = solve(mesh, *random_paint(soup.size)).values
    lines = isolines(mesh, values, even_levels(values.min(), values.max(), count))
    assert_array_equal(np.unique(lines.level), np.arange(count))
    assert_array_equal(lines.levels, even_levels(values.min(), values.max(), count))


def test_a_level_at_a_vertex_passes_through_that_vertex_exactly():
    soup = sphere(9, 12)
    values = soup.positions @ [0.3, -0.2, 0.9]
    lines = isolines(soup.mesh(), values, [values[40]])
    at = np.flatnonzero((lines.points == soup.positions[40]).all(axis=1))
    assert len(at) == 1
    assert lines.t[at[0]] in (0, 1)


def test_a_plateau_lies_above_and_the_line_runs_along_its_rim():
    soup = grid(10, 10)
    x, y, _ = soup.positions.T
    plateau = (np.abs(x - 5) <= 2) & (np.abs(y - 5) <= 2)
    lines = isolines(soup.mesh(), np.where(plateau, 1.0, 0.0), [1.0])
    assert_array_equal(lines.closed, [True])
    assert lines.length[0] == 16
    rim = soup.positions[plateau & ((np.abs(x - 5) == 2) | (np.abs(y - 5) == 2))]
    assert_array_equal(np.unique(lines.points, axis=0), np.unique(rim, axis=0))


def test_a_field_that_is_the_level_everywhere_has_no_line():
    soup = sphere(5, 7)
    assert len(isolines(soup.mesh(), np.ones(soup.size), [1.0])) == 0


def test_the_circle_has_its_length_to_second_order():
    def error(n):
        soup = grid(n, n)
        soup = Soup(2 * soup.positions / n - [1, 1, 0], soup.faces)
        lines = isolines(soup.mesh(), (soup.positions**2).sum(axis=1), [0.25, 0.49])
        assert_array_equal(lines.closed, [True, True])
        return np.abs(lines.length - 2 * np.pi * np.array([0.5, 0.7])).max()

    assert error(100) < 1e-3
    assert np.log2(error(50) / error(100)) > 1.5


def test_lines_of_a_linear_field_are_straight_and_end_on_the_border():
    soup = grid(8, 6)
    lines = isolines(soup.mesh(), soup.positions[:, 0], [2.5, 3.0])
    assert not lines.closed.any()
    assert_array_equal(lines.length, [6, 6])
    for number, x in enumerate([2.5, 3.0]):
        line = lines.line(number)
        assert_array_equal(line[:, 0], x)
        assert_array_equal(np.sort(line[[0, -1], 1]), [0, 6])


@pytest.mark.parametrize("flipped", [False, True])
def test_higher_values_are_on_the_left(flipped):
    soup = sphere(9, 12)
    faces = [face[::-1] for face in soup.faces] if flipped else soup.faces
    height = soup.positions[:, 2]
    lines = isolines(Soup(soup.positions, faces).mesh(), height, [0.1])
    start, end = segments(lines)
    outward = lines.points[start] * (-1 if flipped else 1)
    left = np.cross(outward, lines.points[end] - lines.points[start])
    assert (left[:, 2] > 0).all()


def test_triangles_with_nan_carry_no_line():
    soup = grid(6, 4)
    values = soup.positions[:, 1].copy()
    values[soup.positions[:, 0] > 3] = np.nan
    lines = isolines(soup.mesh(), values, [1.5])
    assert_array_equal(lines.length, [3])
    assert_sound(soup.mesh(), values, lines)


def test_a_field_without_any_number_has_no_line_and_says_so():
    soup = grid(3, 3)
    lines = isolines(soup.mesh(), np.full(soup.size, np.nan), [0.5])
    assert len(lines) == 0
    assert lines.warnings == ("the field has no value at any vertex, so there are no lines",)
    assert isolines(soup.mesh(), np.full(soup.size, np.nan), []).warnings == ()


def test_unpainted_pieces_carry_no_line():
    soup = joined(sphere(5, 7), sphere(5, 7))
    values = solve(soup.mesh(), [0, 36], [0.0, 1.0]).values
    lines = isolines(soup.mesh(), values, [0.5])
    assert_array_equal(lines.closed, [True])
    assert lines.points[:, 0].max() < 5


def test_equal_levels_count_once_and_say_so():
    soup = sphere(5, 7)
    lines = isolines(soup.mesh(), soup.positions[:, 2], [0.1, -0.2, 0.1, 0.1])
    assert_array_equal(lines.level, [0, 1])
    assert any("repeat" in warning for warning in lines.warnings)


def test_levels_come_in_any_order_and_keep_their_place():
    soup = sphere(9, 12)
    shuffled = isolines(soup.mesh(), soup.positions[:, 2], [0.5, -0.5, 0.0])
    for number, level in enumerate([0.5, -0.5, 0.0]):
        assert_allclose(shuffled.points[shuffled.offsets[number] : shuffled.offsets[number + 1], 2], level, atol=1e-15)


def test_levels_outside_the_field_give_no_line_and_a_warning():
    soup = sphere(5, 7)
    lines = isolines(soup.mesh(), soup.positions[:, 2], [-7.0, 7.0, 0.0])
    assert_array_equal(lines.level, [2])
    assert any("outside" in warning for warning in lines.warnings)


def test_the_extremes_give_no_junk():
    soup = sphere(5, 7)
    lines = isolines(soup.mesh(), soup.positions[:, 2], [-1.0, 1.0])
    assert len(lines) == 0


def test_no_levels_give_no_lines():
    assert len(isolines(sphere(5, 7).mesh(), np.arange(37.0), np.empty(0))) == 0


def test_levels_one_ulp_apart_are_two_levels():
    soup = sphere(5, 7)
    lines = isolines(soup.mesh(), soup.positions[:, 2], [0.1, np.nextafter(0.1, 1)])
    assert_array_equal(lines.level, [0, 1])


def test_ten_thousand_levels_each_have_their_line():
    soup = sphere(9, 12)
    values = soup.positions[:, 2]
    lines = isolines(soup.mesh(), values, even_levels(-1, 1, 10_000))
    assert_array_equal(lines.level, np.arange(10_000))


def test_a_line_branches_at_an_edge_with_many_faces():
    lines = isolines(book(5).mesh(), [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.5])
    assert_array_equal(lines.closed, [False] * 5)
    assert_array_equal(np.sort(lines.edges[lines.edges[:, 1] == 1], axis=0), [[0, 1]] * 5)


def test_a_line_across_a_moebius_band_ends_on_its_border():
    soup = moebius(12)
    values = solve(soup.mesh(), [0, 1, 12, 13], [0.0, 0.0, 1.0, 1.0]).values
    lines = isolines(soup.mesh(), values, [0.5])
    assert_array_equal(lines.closed, [False, False])


def test_lines_on_a_klein_bottle_close():
    soup = torus(16, 9, klein=True)
    values = solve(soup.mesh(), [0, 70], [0.0, 1.0]).values
    lines = isolines(soup.mesh(), values, even_levels(0, 1, 20))
    assert lines.closed.all()


def test_a_concave_quad_is_crossed_inside():
    dart = Soup(np.array([[0, 0, 0], [2, -1, 0], [0.5, 0, 0], [2, 1, 0.0]]), [[0, 1, 2, 3]])
    lines = isolines(dart.mesh(), dart.positions[:, 0], [1.0])
    assert_allclose(np.sort(lines.length), [1 / 6, 1 / 6])


def test_two_runs_give_the_same_bits():
    soup = torus(40, 30)
    values = random_values(soup)
    mesh, levels = soup.mesh(), even_levels(-1, 1, 13)
    assert_same_lines(isolines(mesh, values, levels), isolines(soup.mesh(), values, levels))


def test_swapping_up_and_down_keeps_the_curves():
    soup = sphere(9, 12)
    mesh, values = soup.mesh(), random_values(soup)
    up, down = isolines(mesh, values, [0.2]), isolines(mesh, -values, [-0.2])
    assert_allclose(np.sort(up.length), np.sort(down.length), rtol=1e-12)


@pytest.mark.parametrize("bad", [np.inf, -np.inf])
def test_an_infinite_value_is_refused_by_vertex(bad):
    values = np.zeros(37)
    values[[11, 20]] = bad
    with pytest.raises(InputError, match="11"):
        isolines(sphere(5, 7).mesh(), values, [0.5])


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_level_that_is_not_finite_is_refused_by_place(bad):
    with pytest.raises(InputError, match=r"\b2\b"):
        isolines(sphere(5, 7).mesh(), np.zeros(37), [0.5, 0.6, bad])


@pytest.mark.parametrize("values", [np.zeros(36), np.zeros((37, 1)), "text", [None] * 37, np.zeros(37, complex)])
def test_values_that_do_not_fit_the_mesh_are_refused(values):
    with pytest.raises(InputError):
        isolines(sphere(5, 7).mesh(), values, [0.5])


@pytest.mark.parametrize(("scale", "offset"), [(1e-150, 0), (1e140, 0), (1, 1e6)])
def test_scale_and_offset_keep_the_lines(scale, offset):
    soup = sphere(9, 12)
    values = random_values(soup)
    moved = Mesh(soup.positions * scale + offset, soup.faces)
    lines, there = isolines(soup.mesh(), values, [0.2]), isolines(moved, values, [0.2])
    assert_array_equal(lines.edges, there.edges)
    assert_array_equal(lines.t, there.t)
    assert_allclose(there.length, scale * lines.length, rtol=1e-6)
