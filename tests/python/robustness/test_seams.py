# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders that lie on each other without being joined: never a silent jump from 0 to 1."""

import numpy as np
import pytest
from dirichlet_surface import Mesh, find_defects
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import ZOO, Soup, cylinder, grid, sphere, tetrahedron
from outcomes import obj_of, solved, warning_about

ADVICE = "merging by distance would join them"


def sheets_side_by_side() -> Soup:
    """Two grids that meet along 5 vertices, which each has for itself."""
    sheet = grid(4, 4)
    faces = sheet.faces + [[vertex + 25 for vertex in face] for face in sheet.faces]
    beside = sheet.positions + np.array([0, 4, 0])
    return Soup(np.vstack((sheet.positions, beside)), faces)


def slit_cylinder() -> Soup:
    """A cylinder whose first and last column of vertices coincide: one piece, with a seam."""
    flat = grid(8, 5)
    angle = 2 * np.pi * (flat.positions[:, 0] % 8) / 8
    return Soup(np.column_stack((np.cos(angle), np.sin(angle), flat.positions[:, 1])), flat.faces)


def triangle_soup() -> Soup:
    ball = sphere(7, 10)
    corners = np.ravel(ball.faces)
    return Soup(ball.positions[corners], np.arange(len(corners)).reshape(-1, 3).tolist())


SEAMS = {
    "sheets side by side": (sheets_side_by_side(), 5, (20, 25)),
    "slit cylinder": (slit_cylinder(), 6, (0, 8)),
    "triangle soup": (triangle_soup(), 420 - 72, (1, 3)),
}


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize(("soup", "pairs", "first"), SEAMS.values(), ids=SEAMS)
def test_a_seam_is_told_with_its_pairs_and_the_way_out(laplacian, soup, pairs, first):
    field, _ = solved(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], laplacian)
    message = warning_about(ADVICE, field.report.warnings)
    assert message.startswith(f"{pairs} pairs of vertices coincide")
    assert f"{first[0]} and {first[1]}" in message
    assert find_defects(soup.mesh()).coincident_vertices == pairs


@pytest.mark.parametrize(("soup", "pairs", "first"), SEAMS.values(), ids=SEAMS)
def test_a_seam_is_told_on_the_command_line(command, soup, pairs, first):
    mesh = command.write("mesh.obj", obj_of(soup))
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [soup.size - 1]))
    assert f"warning: {pairs} pairs" in warning_about(ADVICE, output.splitlines())


def test_stl_files_are_joined_as_they_are_read(command):
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners)
        + "endloop\nendfacet\n"
        for corners in sphere(7, 10).positions[np.array(sphere(7, 10).faces)].tolist()
    )
    mesh = command.write("mesh.stl", f"solid\n{facets}endsolid\n")
    output = command.accepts(mesh, "--patch", "low=0@0,0,-1,0.1", "--patch", "high=1@0,0,1,0.1")
    assert "72 vertices" in output
    assert "warning" not in output


def tetrahedra_on_each_other() -> Soup:
    """Two closed pieces that share three places."""
    one = tetrahedron()
    other = one.positions.copy()
    other[3] = one.positions[:3].mean(axis=0) * 2 - one.positions[3]
    return Soup(np.vstack((one.positions, other)), one.faces + [[vertex + 4 for vertex in face] for face in one.faces])


def fin_on_a_sheet() -> Soup:
    """A quad that stands on an edge inside a grid, and ends there."""
    sheet = grid(4, 4)
    foot = sheet.positions[[11, 12]]
    return Soup(np.vstack((sheet.positions, foot, foot + np.array([0, 0, 1]))), [*sheet.faces, [25, 26, 28, 27]])


@pytest.mark.parametrize(
    ("soup", "pairs", "first"), [(tetrahedra_on_each_other(), 3, (0, 4)), (fin_on_a_sheet(), 2, (11, 25))]
)
def test_pieces_that_touch_are_told_wherever_they_do(soup, pairs, first):
    field, _ = solved(soup.mesh(), [3, soup.size - 1], [0.0, 1.0])
    message = warning_about(ADVICE, field.report.warnings)
    assert message.startswith(f"{pairs} pairs of vertices coincide (the first: {first[0]} and {first[1]})")


def test_a_surface_that_touches_itself_inside_is_no_seam_though_there_are_other_pieces():
    pinched = sphere(7, 10)
    pinched.positions[20] = pinched.positions[50]
    away = Soup(pinched.positions + np.array([9, 0, 0]), pinched.faces)
    both = np.vstack((pinched.positions, away.positions))
    mesh = Mesh(both, [*pinched.faces, *([vertex + 72 for vertex in face] for face in pinched.faces)])
    assert find_defects(mesh).coincident_vertices == 0


@pytest.mark.parametrize("pinched_first", [True, False])
def test_pieces_that_touch_at_one_place_are_one_pair_whichever_comes_first(pinched_first):
    pinched, other = sphere(7, 10), sphere(7, 10)
    pinched.positions[20] = pinched.positions[50]
    other.positions[:] = other.positions * 0.1 + pinched.positions[50] - 0.1 * other.positions[30]
    other.positions[30] = pinched.positions[50]
    both = [pinched, other] if pinched_first else [other, pinched]
    faces = [*both[0].faces, *([vertex + 72 for vertex in face] for face in both[1].faces)]
    assert find_defects(Mesh(np.vstack([soup.positions for soup in both]), faces)).coincident_vertices == 1


def test_a_vertex_without_faces_stands_wherever_it_likes():
    ball = sphere(7, 10)
    assert find_defects(Mesh(np.vstack((ball.positions, ball.positions)), ball.faces)).coincident_vertices == 0


@pytest.mark.parametrize("soup", [*ZOO.values(), cylinder(8, 5), grid(1, 1)])
def test_ordinary_meshes_hear_nothing_of_seams(soup):
    assert find_defects(soup.mesh()).warnings == ()


def test_minus_zero_is_where_zero_is():
    positions = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-0.0, 0, -0.0], [-1, 0, 0], [0, -1, 0]], float)
    assert find_defects(Mesh(positions, [[0, 1, 2], [3, 4, 5]])).coincident_vertices == 1


def test_vertices_next_to_each_other_do_not_coincide():
    beside = np.nextafter(0.5, 1)
    positions = np.array([[0.5, 0, 0], [1, 0, 0], [1, 1, 0], [beside, 0, 0], [2, 0, 0], [2, -1, 0]])
    assert find_defects(Mesh(positions, [[0, 1, 2], [3, 4, 5]])).warnings == ()


def test_an_edge_that_was_collapsed_is_no_seam():
    sheet = grid(4, 4)
    sheet.positions[2] = sheet.positions[1]  # next to it on the border
    assert find_defects(sheet.mesh()).coincident_vertices == 0
    sheet.positions[23] = sheet.positions[1]  # from across
    (message,) = [warning for warning in find_defects(sheet.mesh()).warnings if ADVICE in warning]
    assert message.startswith("1 pair of vertices coincide")
    assert "1 and 23" in message
