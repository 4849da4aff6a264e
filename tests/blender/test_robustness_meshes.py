# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that no paper has: in Blender they have the field and the lines that the library gives for the same arrays."""

import numpy as np
import pytest

pytest.importorskip("scipy", reason="the Python tests' meshes come with it")

from hostile import all_soups, library_mesh
from scene import add, field_of, paint

SOUPS = all_soups()


def painted(name):
    """The mesh as an object, with six vertices or fewer painted from 0 to 1; positions, faces, vertices, values."""
    positions, faces = SOUPS[name]
    vertices = np.unique(np.random.default_rng(1).integers(len(positions), size=6))
    values = np.linspace(0, 1, len(vertices), dtype=np.float32)
    obj = add(positions.tolist(), faces, name)
    for vertex, value in zip(vertices, values):
        paint(obj, f"at {vertex}", [vertex], float(value))
    return obj, positions, faces, vertices, values


@pytest.mark.parametrize("laplacian", ["graph", "auto"])  # the others refuse meshes without any area
@pytest.mark.parametrize("name", SOUPS)
def test_field_lines_and_warnings_are_the_librarys(surface, pipeline, name, laplacian):
    obj, positions, faces, vertices, values = painted(name)
    obj.dirichlet.laplacian = laplacian
    mesh = library_mesh(surface, positions, faces)
    solved = surface.solve(mesh, vertices, values, laplacian=laplacian)
    field = solved.values.astype(np.float32)
    pipeline.solve_field(obj)
    assert obj.dirichlet.results.field_warnings.splitlines() == list(solved.report.warnings)
    assert [tuple(polygon.vertices) for polygon in obj.data.polygons] == [tuple(face) for face in faces]
    assert np.array_equal(field_of(obj), field, equal_nan=True)
    assert 0 <= np.nanmin(field) <= np.nanmax(field) <= 1
    made = pipeline.make_isolines(obj)
    lines = surface.isolines(mesh, field, surface.even_levels(0, 1, obj.dirichlet.count))
    assert np.array_equal(made.lines.points, lines.points)
    assert_drawn(made, positions)


def assert_drawn(made, positions):
    """Every line that has a length in single precision is a spline, closed or open as the line; none is a point."""
    for spline in made.object.data.splines:
        points = np.array([point.co[:3] for point in spline.points])
        assert np.isfinite(points).all()
        assert len(points) >= 2
        assert (np.diff(points, axis=0) != 0).any(axis=1).all()
    assert len(made.object.data.splines) <= len(made.lines)
    assert not len(made.lines) or np.isfinite(made.lines.points).all()


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("a face twice", "repeats face 0 (and 1 more"),
        ("a corner moved onto another", "has no area"),
        ("two sheets side by side", "2 pairs of vertices coincide"),
        ("a bow tie", "face 0 crosses itself"),
    ],
)
def test_what_is_seldom_meant_is_told_with_its_place(pipeline, name, words):
    square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    positions, faces = {
        "a face twice": ([*square, (2, 0, 0)], [(0, 1, 2, 3), (1, 4, 2), (0, 1, 2, 3), (3, 2, 1, 0)]),
        "a corner moved onto another": ([*square, (1, 0, 0)], [(0, 1, 2, 3), (1, 4, 2)]),
        "two sheets side by side": (square + [(x + 1, y, z) for x, y, z in square], [(0, 1, 2, 3), (4, 5, 6, 7)]),
        "a bow tie": (square, [(0, 2, 1, 3)]),
    }[name]
    obj = add(positions, faces, name)
    paint(obj, "low", [0], 0.0)
    paint(obj, "high", [len(positions) - 1], 1.0)
    assert words in " ".join(pipeline.solve_field(obj).warnings)
    assert words in obj.dirichlet.results.field_warnings


@pytest.mark.parametrize("name", ["Klein bottle", "torus", "sphere", "tetrahedron"])
def test_lines_on_a_surface_without_border_close(pipeline, name):
    obj = painted(name)[0]
    pipeline.solve_field(obj)
    lines = pipeline.make_isolines(obj).lines
    assert len(lines) >= 1
    assert lines.closed.all()


def test_turned_faces_make_no_difference(pipeline):
    obj = painted("quad grid")[0]
    pipeline.solve_field(obj)
    before = field_of(obj)
    for polygon in list(obj.data.polygons)[::2]:
        polygon.flip()
    pipeline.solve_field(obj)
    assert np.array_equal(field_of(obj), before)
    assert obj.data.polygons[0].normal.z == -obj.data.polygons[1].normal.z == -1
    assert len(pipeline.make_isolines(obj).lines) >= 1


def test_of_many_pieces_those_without_paint_are_said_in_one_line(pipeline):
    triangles = [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(900)]
    positions = [(3 * k + x, y, 0) for k in range(900) for x, y in ((0, 0), (1, 0), (0, 1))]
    obj = add(positions, triangles)
    paint(obj, "low", range(0, 2700, 6), 0.0)
    paint(obj, "high", range(1, 2700, 6), 1.0)
    (warning,) = pipeline.solve_field(obj).warnings
    assert "1350 vertices" in warning
    assert "vertex 3" in warning
    assert obj.dirichlet.results.undefined == 1350
    assert len(pipeline.make_isolines(obj).lines) == 450 * obj.dirichlet.count


def test_loose_edges_and_vertices_are_left_out_and_said(pipeline):
    obj = add([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (5, 5, 5), (6, 5, 5)], [(0, 1, 2, 3)])
    obj.data.edges.add(1)
    obj.data.edges[-1].vertices = (3, 4)
    paint(obj, "low", [0], 0.0)
    paint(obj, "high", [2], 1.0)
    (warning,) = pipeline.solve_field(obj).warnings
    assert "2 vertices" in warning
    assert "vertex 4" in warning
    assert np.isnan(field_of(obj)[4:]).all()


def test_a_polygon_of_thousands_of_corners_is_cut_inside(pipeline):
    angle = 2 * np.pi * np.arange(5000) / 5000
    obj = add(np.column_stack((np.cos(angle), np.sin(angle), 0 * angle)).tolist(), [tuple(range(5000))])
    paint(obj, "low", [0], 0.0)
    paint(obj, "high", [2500], 1.0)
    pipeline.solve_field(obj)
    lines = pipeline.make_isolines(obj).lines
    assert len(lines) == obj.dirichlet.count
    assert (np.hypot(*lines.points[:, :2].T) <= 1 + 1e-6).all()
