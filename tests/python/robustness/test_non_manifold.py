# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges and vertices where more than a surface meets: solved; lines may branch there and end."""

import numpy as np
import pytest
from dirichlet_surface import equal_area_levels, find_defects, isolines, solve
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import Soup, book, bow_tie, grid, sphere, torus
from outcomes import obj_of, refusal, solved, warning_about

SPHERE = sphere(7, 10)


def with_repeats() -> Soup:
    """Faces 5, 9 and 5 once more: as they are, turned over, and from another corner."""
    again = [SPHERE.faces[5], SPHERE.faces[9][::-1], np.roll(SPHERE.faces[5], 1).tolist()]
    return Soup(SPHERE.positions, SPHERE.faces + again)


def crossing_sheets() -> Soup:
    """Two sheets that go through each other along a row of vertices that both have."""
    flat = grid(4, 4)
    upright = flat.positions[:, [0, 2, 1]] + [0, 2, -2]
    shared = np.isin(np.arange(25), np.arange(10, 15))  # y = 2 of the one, z = 0 of the other
    number = np.where(shared, np.arange(25), 24 + np.cumsum(~shared))
    faces = flat.faces + [[int(number[vertex]) for vertex in face] for face in flat.faces]
    return Soup(np.vstack((flat.positions, upright[~shared])), faces)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_two_sheets_that_touch_in_a_vertex_are_one_piece(laplacian):
    field, _ = solved(bow_tie().mesh(), [1, 4], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("pages", [3, 4, 5, 6, 7, 8, 9, 10, 11, 12])
def test_any_number_of_faces_on_an_edge_is_solved_and_lines_branch_there(laplacian, pages):
    field, _ = solved(book(pages).mesh(), [0, 1], [0.0, 1.0], laplacian)
    lines = isolines(book(pages).mesh(), field.values, [0.4])
    assert len(lines) == pages
    assert not lines.closed.any()


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_sheets_that_cross_are_one_piece(laplacian):
    field, _ = solved(crossing_sheets().mesh(), [0, 44], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_pillow_of_two_faces_is_closed_and_no_repetition(laplacian):
    mesh = Soup(SPHERE.positions[:3], [[0, 1, 2], [0, 2, 1]]).mesh()
    field, lines = solved(mesh, [0, 1], [0.0, 1.0], laplacian)
    assert lines.closed.all()
    assert field.report.warnings == ()


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_repeated_faces_count_once_with_one_warning(laplacian):
    mesh = with_repeats().mesh()
    field, lines = solved(mesh, [0, 71], [0.0, 1.0], laplacian)
    once, lines_once = solved(SPHERE.mesh(), [0, 71], [0.0, 1.0], laplacian)
    np.testing.assert_array_equal(field.values, once.values)
    np.testing.assert_array_equal(lines.points, lines_once.points)
    assert lines.closed.all()
    message = warning_about("repeats face", field.report.warnings)
    assert "face 140 repeats face 5" in message
    assert "2 more" in message
    assert find_defects(mesh).repeated_faces == 3


def test_repeated_faces_are_told_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(with_repeats()))
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [71]))
    assert "face 140 repeats face 5 (and 2 more" in warning_about("repeats", output.splitlines())


@pytest.mark.parametrize("turned", [False, True], ids=["the same way", "turned over"])
@pytest.mark.parametrize("triangles", [True, False], ids=["triangles", "quads"])
def test_a_surface_with_every_face_twice_has_the_lines_of_one(triangles, turned):
    once = torus(12, 7, triangles)
    again = [face[::-1] if turned else face for face in once.faces]
    fields = [solved(soup.mesh(), [0, 40], [0.0, 1.0]) for soup in (once, Soup(once.positions, once.faces + again))]
    (field, lines), (doubled, lines_doubled) = fields
    np.testing.assert_array_equal(doubled.values, field.values)
    np.testing.assert_array_equal(lines_doubled.points, lines.points)
    assert lines_doubled.closed.all()


@pytest.mark.parametrize("laplacian", ["cotangent", "intrinsic_delaunay"])
def test_a_face_after_a_repeated_one_is_named_by_its_own_number(laplacian):
    sheet = grid(3, 3, triangles=False)
    angle = 4 * np.pi * np.arange(5) / 5
    star = np.column_stack((np.cos(angle), np.sin(angle), 9 + 0 * angle))
    soup = Soup(np.vstack((sheet.positions, star)), [*sheet.faces, sheet.faces[4], [16, 17, 18, 19, 20]])
    heights = soup.positions[:, 0]
    for call, *arguments in (
        (solve, soup.mesh(), [0, 20], [0.0, 1.0]),
        (isolines, soup.mesh(), heights, [0.5]),
        (equal_area_levels, soup.mesh(), heights, 3),
    ):
        options = {"laplacian": laplacian} if call is solve else {}
        assert refusal(call, *arguments, **options).startswith("face 10 crosses itself")
