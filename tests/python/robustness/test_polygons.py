# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons of any shape: lines run inside them, as long as the polygon is wide there, or the face is named."""

import numpy as np
import pytest
from dirichlet_surface import Mesh, find_defects, isolines
from dirichlet_surface.field import LAPLACIANS
from isoline_laws import assert_sound
from mesh_makers import Soup, grid
from outcomes import obj_of, refusal, solved, warning_about


def star(points: int, inner: float = 0.3) -> np.ndarray:
    angle = np.pi * np.arange(2 * points) / points + 0.1
    radius = np.where(np.arange(2 * points) % 2, inner, 1.0)
    return np.column_stack((radius * np.cos(angle), radius * np.sin(angle)))


def spiral(turns: float, corners: int) -> np.ndarray:
    """A band that winds inwards: its outer side, then its inner side back."""
    angle = np.linspace(0, 2 * np.pi * turns, corners)
    radius = np.linspace(1, 0.2, corners)
    width = 0.25 * 0.8 / turns
    sides = [np.column_stack(((radius - w) * np.cos(angle), (radius - w) * np.sin(angle))) for w in (0, width)]
    return np.vstack((sides[0], sides[1][::-1]))


def keyhole() -> np.ndarray:
    """A square with a square hole, cut open along a line that the border runs there and back."""
    outer = [[2, 0], [2, 2], [-2, 2], [-2, -2], [2, -2], [2, 0]]
    inner = [[1, 0], [1, -1], [-1, -1], [-1, 1], [1, 1], [1, 0]]
    return np.array(outer + inner, float)


SHAPES = {
    "concave quad": np.array([[0, 0], [2, 1], [0, 2], [0.5, 1]]),
    "arrow": np.array([[0, 0], [3, 1.5], [0, 3], [1, 1.5]]),
    "L": np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], float),
    "comb": np.array([[0, 0], [7, 0], [7, 3], [6, 3], [6, 1], [4, 1], [4, 3], [3, 3], [3, 1], [1, 1], [1, 3], [0, 3]]),
    "star": star(7),
    "sharp star": star(40, 0.02),
    "spiral": spiral(3, 60),
    "keyhole": keyhole(),
    "with collinear corners": np.array([[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]], float),
}


def width_at(shape: np.ndarray, x: float) -> float:
    """How much of the vertical line at x lies inside, by crossing number."""
    following = np.roll(shape, -1, axis=0)
    crossed = (shape[:, 0] > x) != (following[:, 0] > x)
    a, b = shape[crossed], following[crossed]
    heights = np.sort(a[:, 1] + (x - a[:, 0]) * (b[:, 1] - a[:, 1]) / (b[:, 0] - a[:, 0]))
    return float((heights[1::2] - heights[::2]).sum())


@pytest.mark.parametrize("turned", [False, True], ids=["counter-clockwise", "clockwise"])
@pytest.mark.parametrize("name", SHAPES)
def test_lines_across_a_polygon_are_as_long_as_it_is_wide(name, turned):
    shape = SHAPES[name]
    tilt = np.array([[0.6, 0.0, -0.8], [0.48, 0.6, 0.64]])  # a plane that is parallel to no axis
    face = np.arange(len(shape))[:: -1 if turned else 1]
    mesh = Mesh(shape @ tilt, [face])
    low, high = shape[:, 0].min(), shape[:, 0].max()
    levels = low + (high - low) * np.linspace(0.013, 0.987, 40)
    lines = isolines(mesh, shape[:, 0], levels)
    assert_sound(mesh, shape[:, 0].astype(float), lines)
    lengths = np.bincount(lines.level, lines.length, len(levels))
    np.testing.assert_allclose(lengths, [width_at(shape, level) for level in levels], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("name", SHAPES)
def test_a_polygon_of_any_shape_is_solved(laplacian, name):
    shape = SHAPES[name]
    positions = np.column_stack((shape, 0 * shape[:, 0]))
    field, lines = solved(Mesh(positions, [np.arange(len(shape))]), [0, len(shape) // 2], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0
    assert len(lines) >= 7


def test_a_concave_quad_is_crossed_twice_by_a_level_that_its_hollow_parts():
    shape = SHAPES["arrow"]
    lines = isolines(Mesh(np.column_stack((shape, 0 * shape[:, 0])), [[0, 1, 2, 3]]), shape[:, 0], [0.5])
    assert len(lines) == 2


def pentagram() -> Soup:
    angle = 4 * np.pi * np.arange(5) / 5
    corners = np.column_stack((np.cos(angle) + 20, np.sin(angle), 0 * angle))
    sheet = grid(3, 3)
    return Soup(np.vstack((sheet.positions, corners)), [*sheet.faces, [16, 17, 18, 19, 20], [16, 18, 20, 17, 19]])


def test_a_polygon_that_crosses_itself_is_refused_by_face(command):
    soup = Soup(pentagram().positions, pentagram().faces[:-1])
    message = refusal(isolines, soup.mesh(), soup.positions[:, 0], [0.5])
    assert message == "face 18 crosses itself and cannot be cut into triangles"
    mesh = command.write("mesh.obj", obj_of(soup))
    words = [*command.paint("low", 0, [0, 16]), *command.paint("high", 1, [15, 18])]
    assert "face 18 crosses itself" in command.refuses(mesh, *words)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_quad_that_crosses_itself_is_solved_through_and_told(laplacian, command):
    sheet = grid(4, 4, triangles=False)
    for face in (5, 9):
        a, b, c, d = sheet.faces[face]
        sheet.faces[face] = [a, b, d, c]
    field, _ = solved(sheet.mesh(), [0, 24], [0.0, 1.0], laplacian)
    warning = "face 5 crosses itself (and 1 more face), so its triangles lie on each other"
    assert warning_about("crosses itself", field.report.warnings) == warning
    assert find_defects(sheet.mesh()).crossing_faces == 2
    mesh = command.write("mesh.obj", obj_of(sheet))
    words = [*command.paint("low", 0, [0]), *command.paint("high", 1, [24]), "--laplacian", laplacian]
    assert f"warning: {warning}" in command.accepts(mesh, *words)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("height", [0.1, 1.0, 10.0])
def test_polygons_that_lie_in_no_plane_are_solved(laplacian, height):
    angle = 2 * np.pi * np.arange(12) / 12
    saddle = np.column_stack((np.cos(angle), np.sin(angle), height * np.cos(2 * angle)))
    bent = grid(5, 5, triangles=False)
    bent.positions[:, 2] = height * np.random.default_rng(0).normal(size=bent.size)
    for mesh in (Mesh(saddle, [np.arange(12)]), bent.mesh()):
        field, _ = solved(mesh, [0, mesh.vertex_count // 2], [0.0, 1.0], laplacian)
        assert field.report.undefined == 0


@pytest.mark.parametrize(
    "positions", [np.zeros((6, 3)), np.outer([0, 1, 3, 2, 5, 4], [1.0, 2, 3])], ids=["point", "line"]
)
def test_polygons_without_an_area_are_solved_beside_others_and_counted(positions):
    sheet = grid(3, 3, triangles=False)
    soup = Soup(np.vstack((sheet.positions, positions + 9)), [*sheet.faces, [16, 17, 18, 19, 20, 21]])
    field, _ = solved(soup.mesh(), [0, 15, 16, 18], [0.0, 1.0, 0.0, 1.0])
    assert any("face 9 has no area" in warning for warning in field.report.warnings)


def test_a_level_crosses_two_large_polygons_on_the_same_vertices_as_often_as_each_alone():
    k = 24_000
    turned = np.arange(k)[::-1]
    along = np.concatenate((np.arange(k), turned)) / k
    positions = np.column_stack((along, np.repeat([0.0, 1.0], k), np.zeros(2 * k)))
    comb = np.arange(2 * k)
    field = positions[:, 1]
    alone = isolines(Mesh(positions, comb[None]), field, [0.5])
    both = isolines(Mesh(positions, np.array([comb, comb])), field, [0.5])
    np.testing.assert_allclose(alone.length, [(k - 1) / k])
    assert both.length.sum() == pytest.approx(2 * alone.length.sum(), rel=1e-3)
    assert len(both.points) <= 2 * len(alone.points)
