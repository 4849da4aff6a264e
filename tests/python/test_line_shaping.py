# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines kept, smoothed, simplified, resampled and moved: what each of them promises."""

from dataclasses import replace

import numpy as np
import pytest
from dirichlet_surface import (
    InputError,
    Mesh,
    even_levels,
    isolines,
    keep_long,
    move_lines,
    resample_lines,
    simplify_lines,
    smooth_lines,
)
from isoline_laws import assert_same_lines, edge_keys, line_of_point, ring, segments
from mesh_makers import ZOO, grid, joined, renumbered, sphere, torus
from numpy.testing import assert_allclose, assert_array_equal


def lines_on(soup, levels=5, seed=1):
    """A mesh and the lines of a field that is smooth but for some noise."""
    random, mesh = np.random.default_rng(seed), soup.mesh()
    field = soup.positions @ [1.0, 0.3, -0.7] + random.normal(0, 0.05, soup.size)
    return mesh, isolines(mesh, field, even_levels(field.min(), field.max(), levels))


def lengths_of(lines):
    start, end = segments(lines)
    steps = np.linalg.norm(lines.points[end] - lines.points[start], axis=1)
    return np.bincount(line_of_point(lines)[start], steps, minlength=len(lines))


def distance_to_polyline(points, corners):
    """Of every point to the nearest segment."""
    start, way = corners[:-1], np.diff(corners, axis=0)
    squared = np.maximum((way**2).sum(1), 1e-300)
    t = np.clip(((points[:, None] - start) * way).sum(2) / squared, 0, 1)
    return np.linalg.norm(points[:, None] - (start + t[..., None] * way), axis=2).min(axis=1)


def corners_of(lines, number):
    """The points of a line, its first one again where it closes."""
    points = lines.line(number)
    return np.vstack((points, points[:1])) if lines.closed[number] else points


def same_arrays(one, other):
    assert_array_equal(one.closed, other.closed)
    assert_array_equal(one.level, other.level)
    assert_array_equal(one.levels, other.levels)


SHAPES = {
    "keep_long": lambda mesh, lines: keep_long(lines, 0.5),
    "smooth": lambda mesh, lines: smooth_lines(mesh, lines, 3),
    "simplify": lambda mesh, lines: simplify_lines(lines, 0.05),
    "resample": lambda mesh, lines: resample_lines(lines, 0.13),
    "move": lambda mesh, lines: move_lines(lines, mesh.positions * [1, 2, 3]),
}


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
@pytest.mark.parametrize("name", ZOO)
def test_shaped_lines_are_lines_with_lengths_of_their_own(name, shape):
    mesh, lines = lines_on(ZOO[name])
    before = replace(lines, points=lines.points.copy(), t=lines.t.copy())
    shaped = shape(mesh, lines)
    assert shaped.offsets[-1] == len(shaped.points)
    assert len(shaped.t) == len(shaped.edges) in (0, len(shaped.points))
    assert (np.diff(shaped.offsets) >= 2).all()
    assert_allclose(shaped.length, lengths_of(shaped), rtol=1e-12)
    assert shaped.closed.dtype == np.bool_
    assert_same_lines(lines, before)


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_no_lines_stay_none(shape):
    soup = grid(3, 3)
    lines = isolines(soup.mesh(), np.zeros(soup.size), [5.0])
    assert len(shape(soup.mesh(), lines)) == 0


# --- keeping long ones


def test_only_lines_shorter_than_the_least_go():
    _, lines = lines_on(torus(24, 14), levels=9)
    least = np.median(lines.length)
    kept = keep_long(lines, least)
    stay = np.flatnonzero(lines.length >= least)
    assert 0 < len(kept) == len(stay) < len(lines)
    assert_array_equal(kept.length, lines.length[stay])
    for place, number in enumerate(stay):
        assert_array_equal(kept.line(place), lines.line(number))
    assert_same_lines(keep_long(lines, 0), lines)
    assert len(keep_long(lines, np.inf)) == 0


# --- smoothing


@pytest.mark.parametrize("name", ZOO)
def test_smooth_lines_run_on_the_edges_they_ran_on(name):
    mesh, lines = lines_on(ZOO[name])
    smooth = smooth_lines(mesh, lines, 20)
    same_arrays(smooth, lines)
    assert_array_equal(smooth.edges, lines.edges)
    assert ((smooth.t >= 0) & (smooth.t <= 1)).all()
    assert np.isin(
        edge_keys(mesh.vertex_count, *smooth.edges.T), edge_keys(mesh.vertex_count, *ring(mesh.triangles))
    ).all()
    a, b = mesh.positions[smooth.edges[:, 0]], mesh.positions[smooth.edges[:, 1]]
    assert_allclose(smooth.points, a + smooth.t[:, None] * (b - a), atol=1e-14)


def test_no_step_makes_a_line_longer_and_ends_stay():
    mesh, lines = lines_on(grid(20, 16))
    lengths = np.array([smooth_lines(mesh, lines, steps).length for steps in (0, 1, 2, 3, 10, 30, 100)])
    assert (np.diff(lengths, axis=0) <= 1e-12).all()
    assert (lengths[-1] < lengths[0]).all()
    smooth, is_open = smooth_lines(mesh, lines, 100), ~lines.closed
    assert is_open.any()
    for ends in (lines.offsets[:-1][is_open], lines.offsets[1:][is_open] - 1):
        assert_array_equal(smooth.points[ends], lines.points[ends])


def test_no_step_makes_a_wild_line_longer():
    soup = torus(24, 14)
    mesh, field = soup.mesh(), np.random.default_rng(4).normal(size=soup.size)
    lines = isolines(mesh, field, [-0.4, 0.3])
    lengths = [lines.length]
    for _ in range(8):
        lines = smooth_lines(mesh, lines, 1)
        lengths.append(lines.length)
    assert (np.diff(lengths, axis=0) <= 1e-12).all()
    assert (lengths[-1] < lengths[0]).all()


def test_no_steps_change_nothing_and_two_and_three_make_five():
    mesh, lines = lines_on(torus(24, 14))
    assert_same_lines(smooth_lines(mesh, lines, 0), lines)
    twice = smooth_lines(mesh, smooth_lines(mesh, lines, 2), 3)
    assert_allclose(twice.points, smooth_lines(mesh, lines, 5).points, atol=1e-12)


def test_a_straight_line_stays_straight():
    soup = grid(12, 9)
    mesh = soup.mesh()
    lines = isolines(mesh, soup.positions @ [1.0, 0.37, 0], [3.3, 6.1])
    for level, smooth in zip((3.3, 6.1), map(smooth_lines(mesh, lines, 200).line, range(2)), strict=True):
        assert_allclose(smooth @ [1.0, 0.37, 0], level, atol=1e-12)


def test_a_line_around_a_vertex_does_not_gather_in_it():
    soup = grid(2, 2)
    mesh, field = soup.mesh(), np.zeros(9)
    field[4] = 1
    lines = isolines(mesh, field, [0.5])
    smooth = smooth_lines(mesh, lines, 10_000)
    assert len(smooth) == 1
    assert_allclose(np.minimum(smooth.t, 1 - smooth.t), 0.01, atol=1e-12)
    assert len(np.unique(smooth.points, axis=0)) == len(lines.points)


@pytest.mark.parametrize("scale", [1e-200, 1e-20, 1e20, 1e140])
def test_shapes_grow_with_the_surface(scale):
    mesh, lines = lines_on(torus(24, 14))
    large = Mesh(mesh.positions * scale, mesh.triangles)
    moved = move_lines(lines, large.positions)
    assert_allclose(smooth_lines(large, moved, 7).t, smooth_lines(mesh, lines, 7).t, atol=1e-12)
    assert_allclose(resample_lines(moved, 0.2 * scale).points / scale, resample_lines(lines, 0.2).points, atol=1e-9)
    simple = simplify_lines(lines, 0.05)
    assert_array_equal(simplify_lines(moved, 0.05 * scale).edges, simple.edges)
    assert len(simple.points) < len(lines.points)


def test_a_line_does_not_depend_on_the_others():
    mesh = torus(24, 14).mesh()
    several = isolines(mesh, mesh.positions @ [1.0, 0.3, -0.7], np.linspace(-2, 2, 400))
    assert len(several) > 200  # that threads share
    for shape in SHAPES.values():
        whole = shape(mesh, several)
        for number in (0, len(several) // 2, len(several) - 1):
            alone = keep_long(replace(several, length=np.arange(len(several)) == number), 1)
            if np.isin(alone.level, whole.level).all():
                found = whole.offsets[np.flatnonzero(whole.level == alone.level[0])]
                line = shape(mesh, replace(alone, length=several.length[[number]])).points
                assert any(np.array_equal(whole.points[place : place + len(line)], line) for place in found)


# --- simplifying


@pytest.mark.parametrize("tolerance", [0.0, 1e-3, 0.05, 1.0, np.inf])
@pytest.mark.parametrize("name", ["triangle grid", "torus", "sphere", "Klein bottle", "quad cylinder"])
def test_a_simple_line_is_some_of_the_points_and_the_others_are_near(name, tolerance):
    _, lines = lines_on(ZOO[name])
    simple = simplify_lines(lines, tolerance)
    same_arrays(simple, lines)
    for number in range(len(lines)):
        full, few = lines.line(number), simple.line(number)
        places = [int(np.flatnonzero((full == point).all(axis=1))[0]) for point in few]
        assert places == sorted(set(places))
        assert places[0] == 0
        if lines.closed[number]:
            assert len(few) >= min(3, len(full))
        else:
            assert places[-1] == len(full) - 1
            assert len(few) == 2 or tolerance < np.inf
        if tolerance < np.inf:
            assert distance_to_polyline(full, corners_of(simple, number)).max() <= tolerance * (1 + 1e-9) + 1e-15
    rows = (lines.points[:, None] == simple.points[None]).all(2)
    assert_array_equal(simple.t, lines.t[rows.argmax(0)])


def test_what_lies_straight_becomes_two_points_and_a_square_four():
    soup = grid(10, 10)
    straight = isolines(soup.mesh(), soup.positions[:, 0], [3.5])
    assert len(simplify_lines(straight, 1e-12).points) == 2
    x, y, _ = (soup.positions - 5).T
    square = isolines(soup.mesh(), np.maximum(abs(x), abs(y)), [2.5])
    assert len(square.points) > 20
    corners = simplify_lines(square, 0.0).points - 5
    bends = {(2.5, 2.5), (-2.5, -2.5), (2, -2.5), (2.5, -2), (-2, 2.5), (-2.5, 2)}  # two corners are cut by a triangle
    assert bends <= {(x, y) for x, y, _ in corners.tolist()}
    assert len(corners) <= 7  # and where the line starts


# --- resampling


@pytest.mark.parametrize("name", ["triangle grid", "torus", "sphere", "Klein bottle", "Möbius band"])
@pytest.mark.parametrize("spacing", [0.01, 0.3, 1e9])
def test_even_points_lie_on_the_line_in_even_steps(name, spacing):
    _, lines = lines_on(ZOO[name])
    even = resample_lines(lines, spacing)
    same_arrays(even, lines)
    assert even.edges.shape == (0, 2)
    assert even.t.shape == (0,)
    for number in range(len(lines)):
        points, is_closed = even.line(number), lines.closed[number]
        steps = max(round(lines.length[number] / spacing), 3 if is_closed else 1)
        assert len(points) == (steps if is_closed else steps + 1)
        corners = corners_of(lines, number)
        assert distance_to_polyline(points, corners).max() < 1e-12
        assert_array_equal(points[0], corners[0])
        assert is_closed or (points[-1] == corners[-1]).all()
        chords = np.linalg.norm(np.diff(corners_of(even, number), axis=0), axis=1)
        assert (chords <= lines.length[number] / steps * (1 + 1e-9)).all()
    assert (even.length <= lines.length * (1 + 1e-12)).all()


def test_even_steps_on_a_straight_line_are_equal():
    soup = grid(10, 10)
    lines = isolines(soup.mesh(), soup.positions @ [1, 0.3, 0], [6.1])
    even = resample_lines(lines, lines.length[0] / 7)
    assert_allclose(np.linalg.norm(np.diff(even.points, axis=0), axis=1), lines.length[0] / 7, rtol=1e-12)


# --- moving


def test_lines_moved_nowhere_are_the_same_bit_for_bit_and_follow_a_pose():
    mesh, lines = lines_on(torus(24, 14))
    assert_same_lines(move_lines(lines, mesh.positions), lines)
    turned = mesh.positions @ np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]]) * 3 + [1, 2, 3]
    moved = move_lines(lines, turned)
    assert_allclose(
        moved.points, lines.points @ np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]]) * 3 + [1, 2, 3], atol=1e-12
    )
    assert_allclose(moved.length, 3 * lines.length, rtol=1e-12)


def test_lines_on_a_surface_that_shrank_to_a_point_can_still_be_shaped():
    mesh, lines = lines_on(torus(24, 14))
    point = Mesh(np.ones((mesh.vertex_count, 3)), mesh.triangles)
    gone = move_lines(lines, point.positions)
    assert (gone.length == 0).all()
    assert (smooth_lines(point, gone, 3).t == gone.t).all()
    assert (simplify_lines(gone, 0).points == 1).all()
    assert (resample_lines(gone, 1).points == 1).all()


# --- refusals


@pytest.mark.parametrize("number", [-1, np.nan, "1", None, [1, 2]])
def test_a_length_that_is_none_is_refused(number):
    _, lines = lines_on(grid(4, 4))
    for shape in (keep_long, simplify_lines, resample_lines):
        with pytest.raises(InputError):
            shape(lines, number)


def test_spacings_and_steps_out_of_range_are_refused():
    mesh, lines = lines_on(grid(4, 4))
    for spacing in (0, np.inf, 1e-300, 1e-9):
        with pytest.raises(InputError, match="spacing"):
            resample_lines(lines, spacing)
    for steps in (-1, 10_001, 2.5, "3", 10**12):
        with pytest.raises(InputError, match="number of steps"):
            smooth_lines(mesh, lines, steps)


def test_resampled_lines_do_not_slide_or_move():
    mesh, lines = lines_on(grid(4, 4))
    even = resample_lines(lines, 0.1)
    for call in (lambda: smooth_lines(mesh, even, 1), lambda: move_lines(even, mesh.positions)):
        with pytest.raises(InputError, match="resampled"):
            call()


def test_lines_of_another_mesh_or_on_no_positions_are_refused():
    mesh, lines = lines_on(sphere(7, 10))
    with pytest.raises(InputError, match="the vertices are 0 to 24"):
        smooth_lines(grid(4, 4).mesh(), lines, 1)
    with pytest.raises(InputError, match="the vertices are 0 to 4"):
        move_lines(lines, mesh.positions[:5])
    with pytest.raises(InputError, match="not finite"):
        move_lines(lines, np.full((mesh.vertex_count, 3), np.nan))
    with pytest.raises(InputError, match="positions"):
        move_lines(lines, mesh.positions[:, :2])
    with pytest.raises(InputError, match="Isolines"):
        keep_long(lines.points, 1)


@pytest.mark.parametrize(
    "damage",
    [
        {"offsets": [0, 10**6]},
        {"offsets": [1, 5]},
        {"offsets": []},
        {"closed": []},
        {"level": []},
        {"length": []},
        {"points": np.zeros((3, 3))},
        {"points": np.full((100, 3), np.nan)},
        {"t": [0.5]},
        {"t": np.full(100, 1.5)},
        {"edges": np.zeros((1, 2), int)},
        {"edges": np.full((100, 2), -1)},
    ],
)
def test_arrays_that_do_not_fit_together_are_refused(damage):
    mesh, lines = lines_on(grid(4, 4), levels=1)
    count = len(lines.points)
    damage = {name: value[:count] if len(value) == 100 else value for name, value in damage.items()}
    with pytest.raises(InputError):
        smooth_lines(mesh, replace(lines, **damage), 2)


def test_shaping_does_not_depend_on_how_vertices_are_numbered():
    soup = joined(torus(16, 10), grid(5, 5))
    number = np.random.default_rng(3).permutation(soup.size)
    other = renumbered(soup, number)
    field = soup.positions @ [1.0, 0.3, -0.7]
    moved_field = np.empty_like(field)
    moved_field[number] = field
    one = isolines(soup.mesh(), field, [0.4, 1.3])
    two = isolines(other.mesh(), moved_field, [0.4, 1.3])
    one, two = smooth_lines(soup.mesh(), one, 5), smooth_lines(other.mesh(), two, 5)
    order_one, order_two = np.lexsort(one.points.round(9).T), np.lexsort(two.points.round(9).T)
    assert_allclose(one.points[order_one], two.points[order_two], atol=1e-9)
