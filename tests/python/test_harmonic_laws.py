# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of harmonic fields under injected Dirichlet conditions, on every kind of surface."""

import json

import numpy as np
import pytest
from dirichlet_surface import HarmonicSolver, InputError, Mesh, solve
from mesh_makers import ZOO, Soup, adjacency, cylinder, grid, joined, renumbered, sphere
from numpy.testing import assert_allclose, assert_array_equal
from paintings import random_paint, reference_field

everywhere = pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
both_methods = pytest.mark.parametrize("method", ["direct", "lscg"])


def field_of(soup: Soup, vertices, values, **options) -> np.ndarray:
    return solve(soup.mesh(), vertices, values, **options).values


@everywhere
@both_methods
def test_painted_values_come_back_bit_for_bit(soup, method):
    vertices, values = random_paint(soup.size)
    assert_array_equal(field_of(soup, vertices, values, method=method)[vertices], values)


@everywhere
def test_free_vertices_are_the_average_of_their_neighbours(soup):
    vertices, values = random_paint(soup.size)
    field = field_of(soup, vertices, values)
    A = adjacency(soup)
    free = np.setdiff1d(np.arange(soup.size), vertices)
    average = (A @ field / A.sum(axis=1).A1)[free]
    assert_allclose(field[free], average, rtol=0, atol=1e-10 * np.abs(values).max())


@everywhere
@both_methods
def test_field_stays_in_the_painted_range(soup, method):
    vertices, values = random_paint(soup.size)
    field = field_of(soup, vertices, values, method=method)
    assert values.min() <= field.min()
    assert field.max() <= values.max()


@everywhere
def test_direct_and_least_squares_cg_agree(soup):
    vertices, values = random_paint(soup.size)
    direct, lscg = (field_of(soup, vertices, values, method=method) for method in ("direct", "lscg"))
    assert_allclose(lscg, direct, rtol=0, atol=1e-8 * np.abs(values).max())


@everywhere
def test_field_solves_the_papers_system(soup):
    vertices, values = random_paint(soup.size)
    assert_allclose(field_of(soup, vertices, values), reference_field(soup, vertices, values), rtol=0, atol=1e-10)


@everywhere
@both_methods
def test_a_source_solves_poissons_equation(soup, method):
    vertices, values = random_paint(soup.size)
    source = np.random.default_rng(1).normal(size=soup.size)
    expected = reference_field(soup, vertices, values, source)
    field = field_of(soup, vertices, values, source=source, method=method)
    assert_allclose(field, expected, rtol=0, atol=1e-8 * np.abs(expected).max())
    assert_array_equal(field[vertices], values)


def test_a_positive_source_raises_the_field():
    soup = sphere(7, 10)
    vertices, values = random_paint(soup.size)
    free = np.setdiff1d(np.arange(soup.size), vertices)
    field, raised = (field_of(soup, vertices, values, source=np.full(soup.size, f)) for f in (0.0, 1.0))
    assert (raised[free] > field[free]).all()


@everywhere
def test_indicator_fields_are_a_partition_of_unity(soup):
    vertices, values = random_paint(soup.size)
    indicators = HarmonicSolver(soup.mesh(), vertices).solve(np.eye(len(vertices)))
    assert indicators.min() >= 0
    assert_allclose(indicators.sum(axis=1), 1, atol=1e-12)
    assert_allclose(indicators @ values, field_of(soup, vertices, values), atol=1e-12)


@everywhere
def test_field_is_linear_in_the_values(soup):
    vertices, first = random_paint(soup.size)
    second = np.random.default_rng(2).normal(size=len(vertices))
    solver = HarmonicSolver(soup.mesh(), vertices)
    combined = 2 * solver.solve(first) - 3 * solver.solve(second)
    assert_allclose(solver.solve(2 * first - 3 * second), combined, atol=1e-12)


@everywhere
def test_many_right_hand_sides_are_solved_like_one_by_one(soup):
    vertices, _ = random_paint(soup.size)
    columns = np.random.default_rng(3).normal(size=(len(vertices), 4))
    solver = HarmonicSolver(soup.mesh(), vertices)
    one_by_one = np.column_stack([solver.solve(column) for column in columns.T])
    assert_allclose(solver.solve(columns), one_by_one, rtol=0, atol=1e-14 * np.abs(columns).max())


@everywhere
def test_vertex_order_does_not_matter(soup):
    vertices, values = random_paint(soup.size)
    number = np.random.default_rng(4).permutation(soup.size)
    field = field_of(renumbered(soup, number), number[vertices], values)
    assert_allclose(field[number], field_of(soup, vertices, values), atol=1e-12)


@everywhere
def test_order_of_the_paint_does_not_matter(soup):
    vertices, values = random_paint(soup.size)
    order = np.argsort(vertices)
    assert_array_equal(field_of(soup, vertices, values), field_of(soup, vertices[order], values[order]))


@everywhere
@pytest.mark.parametrize("change", ["face order", "face rotation", "winding", "every other winding", "duplicate faces"])
def test_how_faces_are_written_does_not_change_a_bit(soup, change):
    faces = {
        "face order": soup.faces[::-1],
        "face rotation": [face[1:] + face[:1] for face in soup.faces],
        "winding": [face[::-1] for face in soup.faces],
        "every other winding": [face[:: 1 - 2 * (k % 2)] for k, face in enumerate(soup.faces)],
        "duplicate faces": soup.faces + soup.faces[:2],
    }[change]
    vertices, values = random_paint(soup.size)
    assert_array_equal(field_of(Soup(soup.positions, faces), vertices, values), field_of(soup, vertices, values))


@pytest.mark.parametrize(("scale", "offset"), [(1e20, 0), (1e-20, 0), (1, 1e6), (1e-160, 0), (1e150, 0)])
def test_the_graph_laplacian_does_not_see_positions(scale, offset):
    soup = sphere(7, 10)
    vertices, values = random_paint(soup.size)
    moved = Soup(soup.positions * scale + offset, soup.faces)
    assert_array_equal(field_of(moved, vertices, values), field_of(soup, vertices, values))


@pytest.mark.parametrize("triangles", [True, False])
def test_field_is_linear_along_a_strip(triangles):
    soup = grid(40, 1, triangles=False) if not triangles else cylinder(3, 40)
    along = soup.positions[:, 2 if triangles else 0]
    ends = np.flatnonzero((along == 0) | (along == 40))
    assert_allclose(field_of(soup, ends, along[ends] / 40), along / 40, rtol=0, atol=1e-12)


@pytest.mark.parametrize("triangles", [True, False])
def test_field_is_linear_in_the_height_of_a_cylinder(triangles):
    soup = cylinder(16, 12, triangles)
    height = soup.positions[:, 2]
    rims = np.flatnonzero((height == 0) | (height == 12))
    assert_allclose(field_of(soup, rims, 5 - 2 * height[rims]), 5 - 2 * height, rtol=0, atol=1e-12)


def test_pieces_without_paint_are_nan_and_reported():
    soup = joined(grid(3, 3), sphere(3, 5), grid(2, 2))
    soup = Soup(np.vstack((soup.positions, [[0, 0, 5]])), soup.faces)  # a lone vertex too
    field = solve(soup.mesh(), [0, 15], [1.0, 2.0])
    assert np.isfinite(field.values[:16]).all()
    assert np.isnan(field.values[16:]).all()
    assert (field.report.undefined, field.report.first_undefined) == (soup.size - 16, 16)
    assert any("16" in warning for warning in field.report.warnings)


def test_a_piece_without_paint_does_not_disturb_the_others():
    soup = grid(5, 5)
    vertices, values = random_paint(soup.size)
    field = field_of(joined(soup, sphere(3, 5)), vertices, values)
    assert_allclose(field[: soup.size], field_of(soup, vertices, values), atol=1e-13)


@pytest.mark.parametrize("value", [1.0, 0.1, -1e300, 5e-324])
@both_methods
def test_equal_paint_gives_exactly_that_constant_and_a_warning(value, method):
    field = solve(sphere(7, 10).mesh(), [3, 20, 40], [value] * 3, method=method)
    assert (field.values == value).all()
    assert any("constant" in warning for warning in field.report.warnings)


def test_a_mesh_painted_all_over_keeps_its_values():
    soup = sphere(5, 6)
    values = np.random.default_rng(5).normal(size=soup.size)
    assert_array_equal(field_of(soup, np.arange(soup.size), values), values)


@pytest.mark.parametrize(
    ("low", "high"), [(-1e300, 1e300), (1.0, np.nextafter(1.0, 2)), (0, 5e-324), (-1.7e308, 1.7e308)]
)
def test_extreme_values_stay_finite_and_in_range(low, high):
    soup = grid(9, 9)
    field = field_of(soup, [0, soup.size - 1], [low, high])
    assert np.isfinite(field).all()
    assert low <= field.min()
    assert field.max() <= high


def test_a_vertex_painted_twice_alike_counts_once():
    soup = grid(4, 4)
    once = solve(soup.mesh(), [0, 24], [0.0, 1.0])
    twice = solve(soup.mesh(), [0, 24, 0], [0.0, 1.0, 0.0])
    assert_array_equal(once.values, twice.values)
    assert twice.report.painted == 2


@both_methods
def test_the_report_adds_up(method):
    soup = joined(sphere(7, 10), grid(2, 2))
    field = solve(soup.mesh(), [0, 71, 30], [0.0, 1.0, 0.5], method=method)
    report = field.report
    assert (report.laplacian, report.method) == ("graph", method)
    assert report.vertices == soup.size
    assert report.painted == 3
    assert report.undefined == 9
    assert report.unknowns == soup.size - 3 - 9
    assert report.nonzeros > report.unknowns
    assert (report.factor_nonzeros > 0) == (method == "direct")
    assert (report.iterations > 0) == (method == "lscg")
    assert 0 <= report.relative_residual <= 1e-10
    assert (report.minimum, report.maximum) == (np.nanmin(field.values), np.nanmax(field.values))
    assert (report.painted_minimum, report.painted_maximum) == (0.0, 1.0)
    assert set(report.seconds) == {"connectivity", "laplacian", "analysis", "injection", "factorisation", "solve"}
    assert all(seconds >= 0 for seconds in report.seconds.values())
    assert json.loads(json.dumps(report.to_dict())) == {**vars(report), "warnings": list(report.warnings)}
    assert "\n" not in report.summary()
    assert f"of {soup.size} vertices solved (9 without a value)" in report.summary()


def test_two_solves_give_the_same_bits():
    soup = sphere(20, 30)
    vertices, values = random_paint(soup.size)
    assert_array_equal(field_of(soup, vertices, values), field_of(soup, vertices, values))


def test_a_solver_outlives_its_mesh():
    soup = grid(8, 8)
    vertices, values = random_paint(soup.size)
    mesh = Mesh(soup.positions.copy(), np.array(soup.faces))
    solver = HarmonicSolver(mesh, vertices)
    del mesh
    assert_array_equal(solver.solve(values), field_of(soup, vertices, values))


def test_no_values_for_a_painted_vertex_is_refused():
    with pytest.raises(InputError, match="0 values were given for 1 painted"):
        field_of(grid(3, 3), [0], [])
