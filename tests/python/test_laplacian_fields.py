# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of the fields that the Laplacians make: closed forms, the painted range, and whatever else solves them."""

import numpy as np
import pytest
from dirichlet_surface import LAPLACIANS, HarmonicSolver, InputError, solve
from laplacians import GEOMETRIC, border, hexagons, obtuse_strip, pentagram, rotated, shaken
from mesh_makers import ZOO, Soup, cylinder, grid, joined, sphere, torus
from numpy.testing import assert_allclose, assert_array_equal
from paintings import random_paint

everywhere = pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
every_laplacian = pytest.mark.parametrize("laplacian", LAPLACIANS)
geometric = pytest.mark.parametrize("laplacian", GEOMETRIC)

PLANES = {
    "triangles": shaken(grid(9, 7), 0.3),
    "slanted triangles": rotated(shaken(grid(9, 7), 0.3)),
    "obtuse triangles": obtuse_strip(8),
    "quads": shaken(grid(9, 7, triangles=False), 0.2),
    "hollow quads": rotated(shaken(grid(9, 7, triangles=False), 0.38)),
    "hexagons": rotated(shaken(hexagons(6), 0.25)),
    "flat quads": Soup(grid(9, 7, triangles=False).positions * [1e3, 1e-3, 0], grid(9, 7, triangles=False).faces),
}


@pytest.mark.parametrize("soup", PLANES.values(), ids=PLANES.keys())
@geometric
def test_a_plane_reproduces_linear_functions(soup, laplacian):
    rim = border(soup)
    x = soup.positions - soup.positions.mean(axis=0)
    linear = x @ ([0.3, -1.2, 0.7] / np.ptp(x, axis=0).clip(1e-9))
    assert len(rim) < soup.size
    field = solve(soup.mesh(), rim, linear[rim], laplacian=laplacian).values
    assert_allclose(field, linear, rtol=0, atol=1e-12 * np.ptp(linear))


def annulus(n: int, triangles: bool) -> tuple[Soup, np.ndarray, np.ndarray]:
    """Radii 1 to 3 in n steps, shifted rings; the painted rims and log r / log 3."""
    soup = cylinder(4 * n, n, triangles)
    height = soup.positions[:, 2] / n
    angle = np.arctan2(soup.positions[:, 1], soup.positions[:, 0]) + 0.4 * height
    radius = 1 + 2 * height
    flat = np.column_stack((radius * np.cos(angle), radius * np.sin(angle), 0 * angle))
    return Soup(flat, soup.faces), np.flatnonzero((height == 0) | (height == 1)), np.log(radius) / np.log(3)


def zone(n: int, triangles: bool) -> tuple[Soup, np.ndarray, np.ndarray]:
    """The unit sphere between 45° and 135°, n rings; its painted rims and log tan(θ/2)."""
    soup = cylinder(4 * n, n, triangles)
    height = soup.positions[:, 2] / n
    theta = np.pi / 4 + np.pi / 2 * height
    angle = np.arctan2(soup.positions[:, 1], soup.positions[:, 0]) + 0.3 * height
    round_ = np.column_stack((np.sin(theta) * np.cos(angle), np.sin(theta) * np.sin(angle), np.cos(theta)))
    return Soup(round_, soup.faces), np.flatnonzero((height == 0) | (height == 1)), np.log(np.tan(theta / 2))


@pytest.mark.parametrize("surface", [annulus, zone])
@pytest.mark.parametrize("triangles", [True, False])
@geometric
def test_closed_forms_are_met_at_second_order(surface, triangles, laplacian):
    errors = []
    for n in (8, 16, 32):
        soup, rims, exact = surface(n, triangles)
        field = solve(soup.mesh(), rims, exact[rims], laplacian=laplacian).values
        errors.append(np.abs(field - exact).max())
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert errors[-1] < 1e-3
    assert (orders > 1.85).all()


def test_laplacians_agree_under_refinement():
    gaps = []
    for n in (16, 32, 64):
        fields = {}
        for laplacian in GEOMETRIC:
            soup = torus(2 * n, n, triangles=False)
            around = np.arange(soup.size) % (2 * n) / (2 * n)
            painted = np.flatnonzero((around == 0) | ((around == 0.375) & (soup.positions[:, 2] > -0.01)))
            values = (around[painted] > 0).astype(float)
            fields[laplacian] = solve(soup.mesh(), painted, values, laplacian=laplacian).values
        gaps.append(max(np.abs(fields[a] - fields[b]).mean() for a in GEOMETRIC for b in GEOMETRIC))
    assert gaps[1] < 0.6 * gaps[0]
    assert gaps[2] < 0.6 * gaps[1]


@geometric
def test_a_source_is_a_force_on_every_area(laplacian):
    soup = grid(10, 4)  # right angles: exact in the vertices
    x = soup.positions[:, 0]
    ends = np.flatnonzero((x == 0) | (x == 10))
    field = solve(soup.mesh(), ends, 0 * ends, source=np.ones(soup.size), laplacian=laplacian)
    assert_allclose(field.values, x * (10 - x) / 2, rtol=1e-12, atol=1e-12)
    assert (field.report.outside, field.report.warnings) == (0, ())


@everywhere
@every_laplacian
@pytest.mark.parametrize("how", [{"method": "multigrid"}, {"method": "lscg"}, {"precision": "float32"}], ids=str)
def test_every_method_finds_the_same_field(soup, laplacian, how):
    vertices, values = random_paint(soup.size)
    direct = solve(soup.mesh(), vertices, values, laplacian=laplacian, method="direct")
    other = solve(soup.mesh(), vertices, values, laplacian=laplacian, **how)
    assert direct.report.relative_residual <= 1e-12
    assert_allclose(other.values, direct.values, rtol=0, atol=1e-8 * np.abs(values).max())


@pytest.mark.parametrize("method", ["direct", "multigrid"])
@every_laplacian
def test_obtuse_triangles_do_not_trouble_a_method(laplacian, method):
    soup = obtuse_strip(40)
    vertices, values = random_paint(soup.size, share=0.02)
    exact = solve(soup.mesh(), vertices, values, laplacian=laplacian, method="direct").values
    field = solve(soup.mesh(), vertices, values, laplacian=laplacian, method=method).values
    assert_allclose(field, exact, rtol=0, atol=1e-7 * np.abs(values).max())


@everywhere
@every_laplacian
def test_painted_values_come_back_bit_for_bit(soup, laplacian):
    vertices, values = random_paint(soup.size)
    assert_array_equal(solve(soup.mesh(), vertices, values, laplacian=laplacian).values[vertices], values)


@everywhere
@every_laplacian
def test_equal_paint_gives_exactly_that_constant(soup, laplacian):
    field = solve(soup.mesh(), [0, soup.size - 1], [0.1, 0.1], laplacian=laplacian)
    assert (field.values == 0.1).all()
    assert field.report.outside == 0


@pytest.mark.parametrize(("scale", "offset"), [(1e-160, 0), (1e-150, 0), (1e20, 0), (1e149, 0), (1, 1e6)])
@every_laplacian
@everywhere
def test_fields_do_not_see_scale_and_offset(soup, laplacian, scale, offset):
    if laplacian == "auto" and offset:
        return  # an offset's rounding may decide another way
    vertices, values = random_paint(soup.size)
    moved = Soup(soup.positions * scale + offset, soup.faces)
    fields = [solve(each.mesh(), vertices, values, laplacian=laplacian).values for each in (soup, moved)]
    assert_allclose(*fields, rtol=0, atol=1e-11 if offset == 0 else 1e-6)


def one_above_all(laplacian: str):
    soup = obtuse_strip(9)
    return solve(soup.mesh(), [*border(soup)[1:], 44], [*np.zeros(len(border(soup)) - 1), 1.0], laplacian=laplacian)


def test_cotangents_of_obtuse_triangles_leave_the_range_and_the_report_says_so():
    field = one_above_all("cotangent")
    report = field.report
    outside = (field.values < 0) | (field.values > 1)
    assert report.outside == outside.sum() > 0
    assert report.farthest_outside == max(-field.values.min(), field.values.max() - 1) > 1e-3
    assert report.minimum < 0
    [warning] = report.warnings
    assert warning.startswith(f"{report.outside} values lie outside the painted range, by up to 0.0")
    assert "intrinsic Delaunay" in warning


def test_a_column_of_small_values_is_measured_by_its_own_range():
    soup = obtuse_strip(9)
    rim = border(soup)
    low = np.append(np.zeros(len(rim) - 1), 1.0)
    painted = [*rim[1:], 44]
    linear = 1e12 * soup.positions[painted, 0]  # stays in its range
    solver = HarmonicSolver(soup.mesh(), painted, laplacian="cotangent")
    for columns in (low, np.column_stack((low, linear)), np.column_stack((linear, 1e-3 * low))):
        solver.solve(columns)
        [warning] = solver.report.warnings
        assert "outside the painted range" in warning


@pytest.mark.parametrize(("laplacian", "said"), [("graph", 0), ("intrinsic_delaunay", 1), ("auto", 1)])
def test_the_others_keep_it_and_say_what_they_leave_out_for_that(laplacian, said):
    field = one_above_all(laplacian)
    assert field.values.min() >= 0
    assert field.values.max() <= 1
    assert field.report.farthest_outside < 1e-12
    assert len(field.report.warnings) == said
    assert all(warning.startswith("1 border edge that is not painted") for warning in field.report.warnings)


def regular_polygon(corners: int) -> Soup:
    angle = 2 * np.pi * np.arange(corners) / corners
    return Soup(np.column_stack((np.cos(angle), np.sin(angle), 0 * angle)), [list(range(corners))])


LONG = Soup(grid(5, 4, triangles=False).positions * [9, 1, 1], grid(5, 4, triangles=False).faces)

CHOICES = {
    "right triangles": (grid(5, 4), "cotangent", "no cotangent weight of these triangles is negative"),
    "obtuse triangles": (obtuse_strip(5), "intrinsic_delaunay", "some cotangent weights of these triangles are"),
    "squares": (grid(5, 4, triangles=False), "polygon", "the faces are polygons none of whose weights is negative"),
    "long quads": (LONG, "intrinsic_delaunay", "some weights of these polygons are negative"),
    "a polygon that crosses itself": (joined(LONG, pentagram()), "graph", "a polygon crosses itself"),
    "a polygon of very many corners": (regular_polygon(300), "intrinsic_delaunay", "polygons of so many corners"),
    "a line": (Soup(grid(5, 1).positions * [1, 0, 0], grid(5, 1).faces), "graph", "no face has an area"),
}


def test_a_field_short_of_its_equations_says_so():
    soup = grid(20, 20)
    field = solve(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], method="lscg", tolerance=1e-3)
    assert field.report.relative_residual > 1e-8
    assert "the field holds to its equations only to a relative residual of" in " ".join(field.report.warnings)


@pytest.mark.parametrize(("soup", "taken", "reason"), CHOICES.values(), ids=CHOICES.keys())
def test_auto_takes_what_keeps_the_range_and_says_why(soup, taken, reason):
    field = solve(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], laplacian="auto")
    assert field.report.laplacian == taken
    assert field.report.reason.startswith(reason)
    named = solve(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], laplacian=taken)
    assert_array_equal(field.values, named.values)
    assert named.report.reason == ""


@everywhere
def test_auto_does_not_depend_on_the_numbering(soup):
    number = np.random.default_rng(4).permutation(soup.size)
    faces = [[int(number[v]) for v in face] for face in soup.faces[::-1]]
    positions = np.empty_like(soup.positions)
    positions[number] = soup.positions
    reports = [
        solve(each.mesh(), [0, 1], [0.0, 1.0], laplacian="auto").report for each in (soup, Soup(positions, faces))
    ]
    assert reports[0].laplacian == reports[1].laplacian


FLAT = {
    "a corner on a side": [[0, 0, 0], [2, 0, 0], [4, 0, 0]],
    "two corners in one place": [[0, 0, 0], [0, 0, 0], [4, 0, 0]],
    "all corners in one place": [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
}


@pytest.mark.parametrize("corners", FLAT.values(), ids=FLAT.keys())
@geometric
def test_faces_without_area_are_solved_through_counted_and_named(corners, laplacian):
    good = grid(4, 4)
    soup = joined(good, Soup(np.vstack((corners, [[-1, -1, 0]])), [[0, 1, 2], [0, 2, 3]]))
    solver = HarmonicSolver(soup.mesh(), laplacian=laplacian)
    field = solver.paint([0, 25, 28], [0.0, 1.0, 2.0])
    assert np.isfinite(field).all()
    first = len(good.faces)
    said = (f"face {first} has no area", f"face {first} has no area (and 1 more face)")
    assert solver.report.warnings[0] == said[solver.report.flat_faces - 1]
    solver.paint([0, 26], [0.0, 1.0])
    assert solver.report.warnings[0] == said[solver.report.flat_faces - 1]


def with_thin_triangle(kind: str, thickness: float) -> Soup:
    """A plane in which a corner of a triangle has moved to another, or to the side opposite."""
    soup = grid(6, 6)
    x = soup.positions.copy()
    a, b, c = soup.faces[26]  # inside
    x[b] = (x[a] if kind == "needle" else (x[a] + x[c]) / 2) + thickness * (x[b] - x[a])
    return Soup(x, soup.faces)


@pytest.mark.parametrize("thickness", [1e-6, 1e-9, 1e-12, 1e-15, 1e-30, 0.0])
@pytest.mark.parametrize("kind", ["needle", "cap"])
@pytest.mark.parametrize("method", ["direct", "multigrid"])
@geometric
def test_needles_and_caps_in_a_plane_hardly_disturb_a_linear_function(laplacian, method, kind, thickness):
    soup = with_thin_triangle(kind, thickness)
    rim = border(soup)
    linear = soup.positions @ [1.0, 0.5, 0.0]
    field = solve(soup.mesh(), rim, linear[rim], laplacian=laplacian, method=method)
    assert_allclose(field.values, linear, rtol=0, atol=1e-6)


def test_a_solver_of_two_paintings_has_one_laplacian():
    soup = sphere(7, 10)
    solver = HarmonicSolver(soup.mesh(), laplacian="polygon")
    vertices, values = random_paint(soup.size)
    solver.paint([0], [1.0])
    field = solver.paint(vertices, values)
    assert_array_equal(field, solve(soup.mesh(), vertices, values, laplacian="polygon").values)
    assert solver.report.laplacian == "polygon"


@pytest.mark.parametrize("name", ["mesh", "", None, []])
def test_a_laplacian_that_there_is_not_is_refused(name):
    with pytest.raises(InputError, match="there is no Laplacian"):
        HarmonicSolver(grid(2, 2).mesh(), laplacian=name)
