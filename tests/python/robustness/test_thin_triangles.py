# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles ever thinner: fields as exact as their weights, beside rational numbers, or a word about lost digits."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from dirichlet_surface import Mesh, solve
from mesh_makers import Soup, grid, split
from outcomes import refusal, warning_about

COLUMNS, ROWS = 6, 4
THIN = [2.0**-10, 2.0**-20, 2.0**-30, 2.0**-40]
#: A grid with a face of no area at its rim, whose other two vertices are at one place.
FLAP = [[5.0, -1.0, 0.0], [5.0, -1.0, 0.0]]


def strip(height: float, seed: int, shift: float = 0.0) -> Soup:
    """Rows of quads `height` as high as they are wide, shaken up and down and cut at random; in whole 256ths. Every
    other row is shifted along."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(COLUMNS + 1.0), np.arange(ROWS + 1.0))
    y += random.integers(-100, 101, y.shape) / 256
    x[1::2] += shift
    faces = []
    for a in (row * (COLUMNS + 1) + column for row in range(ROWS) for column in range(COLUMNS)):
        quad, s = [a, a + 1, a + COLUMNS + 2, a + COLUMNS + 1], random.integers(2)
        faces += [[quad[s], quad[s + 1], quad[s + 2]], [quad[s], quad[s + 2], quad[s - 1]]]
    return Soup(np.column_stack((x.ravel(), height * y.ravel(), 0 * x.ravel())), faces)


Weights = dict[tuple[int, int], Fraction]


def exact_weights(soup: Soup, *, flipped: bool) -> Weights:
    """Half the cotangents opposite to every edge, of the Delaunay triangles if flipped, and then none below 0."""
    x, y = ([Fraction(value) for value in column] for column in soup.positions.T[:2])

    def half_cotangent(a: int, b: int, tip: int) -> Fraction:
        u, v = (x[a] - x[tip], y[a] - y[tip]), (x[b] - x[tip], y[b] - y[tip])
        return (u[0] * v[0] + u[1] * v[1]) / abs(u[0] * v[1] - u[1] * v[0]) / 2

    tips = {(face[k - 2], face[k - 1]): face[k] for face in soup.faces for k in range(3)}
    waiting = list(tips) if flipped else []
    while waiting:
        edge = a, b = waiting.pop()
        if edge not in tips or edge[::-1] not in tips:
            continue
        one, other = tips[edge], tips[edge[::-1]]
        if half_cotangent(a, b, one) + half_cotangent(a, b, other) < 0:
            del tips[edge], tips[edge[::-1]]
            for triangle in ((other, b, one), (one, a, other)):
                sides = {(triangle[k - 2], triangle[k - 1]): triangle[k] for k in range(3)}
                tips |= sides
                waiting += sides
    weights: Weights = {}
    for (a, b), tip in tips.items():
        for edge in ((a, b), (b, a)):
            weights[edge] = weights.get(edge, Fraction(0)) + half_cotangent(a, b, tip)
    return {edge: max(weight, Fraction(0)) if flipped else weight for edge, weight in weights.items()}


def exact_field(size: int, weights: Weights, painted: dict[int, float]) -> np.ndarray:
    """By Gauss's elimination."""
    matrix = [[Fraction(0)] * (size + 1) for _ in range(size)]
    for (a, b), weight in weights.items():
        if a not in painted:
            matrix[a][a] += weight
            matrix[a][b] -= weight
    for vertex, value in painted.items():
        matrix[vertex][vertex], matrix[vertex][size] = Fraction(1), Fraction(value)
    for k, pivot in enumerate(matrix):
        pivot[k:] = [entry / pivot[k] for entry in pivot[k:]]
        for row in matrix:
            if row is not pivot and row[k]:
                row[k:] = [a - row[k] * b for a, b in zip(row[k:], pivot[k:])]
    return np.array([float(row[size]) for row in matrix])


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("height", [1.0, *THIN])
@pytest.mark.parametrize("laplacian", ["cotangent", "intrinsic_delaunay", "auto"])
def test_fields_on_triangles_down_to_1e_12_are_exact_to_fourteen_digits(laplacian, height, seed):
    soup = strip(height, seed)
    painted = {0: 0.0, soup.size - 1: 1.0}
    field = solve(soup.mesh(), list(painted), list(painted.values()), laplacian=laplacian)
    flipped = field.report.laplacian == "intrinsic_delaunay"
    expected = exact_field(soup.size, exact_weights(soup, flipped=flipped), painted)
    np.testing.assert_allclose(field.values, expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("height", [2.0**-k for k in (0, 8, 14, 16, 18, 20, 22, 26, 30, 40)])
@pytest.mark.parametrize("shift", [0.5, 0.375])
@pytest.mark.parametrize("laplacian", ["cotangent", "intrinsic_delaunay"])
def test_caps_are_exact_but_for_the_feet_that_flips_tell_by_rounding_or_said_to_be_thickened(
    laplacian, shift, height, seed
):
    soup, flipped = strip(height, seed, shift), laplacian == "intrinsic_delaunay"
    painted = {0: 0.0, soup.size - 1: 1.0}
    field = solve(soup.mesh(), list(painted), list(painted.values()), laplacian=laplacian)
    if flipped and height <= 2.0**-20:
        assert "as thicker" in warning_about("intrinsic Delaunay Laplacian takes", field.report.warnings)
        return
    assert not any("as thicker" in warning for warning in field.report.warnings)
    expected = exact_field(soup.size, exact_weights(soup, flipped=flipped), painted)
    bound = 1e-13 + flipped * 0.02 * np.finfo(float).eps / height**2
    np.testing.assert_allclose(field.values, expected, rtol=0, atol=bound)


def test_a_vertex_of_very_many_faces_elsewhere_takes_no_digit():
    soup, sectors = strip(THIN[-1], 0), 100_000
    angle = 2 * np.pi * np.arange(sectors) / sectors
    cone = np.vstack(([0, 0, 9], np.column_stack((np.cos(angle), np.sin(angle), 0 * angle + 8))))
    fan = [[soup.size, soup.size + 1 + k, soup.size + 1 + (k + 1) % sectors] for k in range(sectors)]
    both = Soup(np.vstack((soup.positions, cone)), [*soup.faces, *fan])
    painted = {0: 0.0, soup.size - 1: 1.0}
    field = solve(both.mesh(), list(painted), list(painted.values()), laplacian="intrinsic_delaunay")
    expected = exact_field(soup.size, exact_weights(soup, flipped=True), painted)
    np.testing.assert_allclose(field.values[: soup.size], expected, rtol=0, atol=1e-14)


@pytest.mark.parametrize("options", [{"method": "multigrid"}, {"precision": "float32"}, {"method": "lscg"}], ids=str)
def test_what_loses_the_digits_of_thin_triangles_says_so_or_refuses(options):
    def run(height: float):
        soup = strip(height, 0)
        return solve(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], laplacian="intrinsic_delaunay", **options)

    assert not run(1.0).report.warnings
    assert "1e8 times others" in warning_about("very thin faces", run(2.0**-16).report.warnings)
    assert "the direct method in float64" in refusal(run, 2.0**-30)


@pytest.mark.parametrize("options", [{"method": "multigrid"}, {"precision": "float32"}, {"method": "lscg"}], ids=str)
def test_what_levels_the_weights_of_vertices_that_all_but_touch_says_so(options):
    """At a cube hangs a fin of a free vertex, a quarter of the way from 0 to the other painted one."""
    cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]

    def run(width: float, **others):
        mesh = Mesh([*cube, [-width, 0, 0], [-4 * width, 0, 0]], [*split(sides), [0, 8, 2], [8, 9, 2]])
        return solve(mesh, [0, 9], [0.0, 1.0], laplacian="intrinsic_delaunay", **others)

    np.testing.assert_allclose(run(1e-9).values[8], 0.25, rtol=1e-9)
    assert not any("1e8 times" in warning for warning in run(1e-7, **options).report.warnings)
    np.testing.assert_allclose(run(1e-7, **options).values[8], 0.25, rtol=1e-7)
    assert "may have lost" in warning_about("1e8 times others", run(1e-9, **options).report.warnings)


@pytest.mark.parametrize("painted", [{2: 0.0, 3: 1.0}, {2: 1.0}, {2: 0.0, 100: 1.0, 5002: 0.3}], ids=str)
def test_multigrid_is_content_with_what_rounding_leaves_beside_a_vertex_of_ten_thousand_faces(painted):
    count = 10_000
    angle = 2 * np.pi * np.arange(count) / count
    rim = np.column_stack((np.cos(angle), np.sin(angle), 0 * angle))
    here = np.arange(count)
    ahead = (here + 1) % count
    faces = np.vstack(
        (np.column_stack((0 * here, here + 2, ahead + 2)), np.column_stack((here**0, ahead + 2, here + 2)))
    )
    mesh = Mesh(np.vstack(([[0, 0, 1], [0, 0, -1]], rim)), faces)
    fields = [solve(mesh, list(painted), list(painted.values()), method=m).values for m in ("multigrid", "direct")]
    np.testing.assert_allclose(*fields, rtol=0, atol=1e-8)


def test_a_memory_budget_leaves_multigrid_to_thin_triangles_as_far_as_it_can_tell_their_field():
    def run(height: float, **options):
        soup = grid(30, 30)
        soup.positions[:, 1] *= height
        return solve(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], laplacian="auto", **options)

    field = run(1e-6, memory_budget=1)
    assert field.report.method == "multigrid"
    assert "more than the memory budget" in warning_about("very thin faces", field.report.warnings)
    np.testing.assert_allclose(field.values, run(1e-6).values, rtol=0, atol=1e-2)
    assert "all that the memory budget allows" in refusal(run, 1e-8, memory_budget=1)


@pytest.mark.parametrize("laplacian", ["graph", "cotangent", "intrinsic_delaunay", "auto"])
@pytest.mark.parametrize("corner", [9, 220])
def test_a_flap_without_area_leaves_the_field_beside_it_alone(laplacian, corner):
    whole = grid(20, 20)
    flapped = Soup(np.vstack((whole.positions, FLAP)), [*whole.faces, [corner, whole.size, whole.size + 1]])
    painted, values = [0, 430, whole.size - 1], [0.0, 0.3, 1.0]
    alone = solve(whole.mesh(), painted, values, laplacian=laplacian).values
    field = solve(flapped.mesh(), painted, values, laplacian=laplacian).values
    np.testing.assert_allclose(field[: whole.size], alone, rtol=0, atol=1e-12)
    np.testing.assert_allclose(field[whole.size :], alone[corner], rtol=0, atol=1e-12)


@pytest.mark.parametrize("laplacian", ["graph", "cotangent", "intrinsic_delaunay", "auto"])
def test_faces_with_two_corners_at_one_place_hand_on_the_field(laplacian):
    positions = [[1, 3, 2], [2, 1, 2], [1, 3, 2], [3, 0, 3], [3, 0, 3], [1, 2, 3], [0, 3, 3], [1, 0, 3], [2, 2, 2]]
    soup = Soup(np.array(positions, float), [[0, 8, 1], [8, 6, 0], [7, 5, 1], [4, 3, 7]])
    field = solve(soup.mesh(), [2, 6], [0.0, 1.0], laplacian=laplacian).values
    assert field.tolist() == [1, 1, 0, 1, 1, 1, 1, 1, 1]
