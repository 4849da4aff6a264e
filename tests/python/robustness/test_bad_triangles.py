# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles without area or nearly so: the field stays in the painted range, faces without area are counted."""

import numpy as np
import pytest
from dirichlet_surface import DirichletError, Mesh, find_defects, solve
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import Soup, grid, sphere
from outcomes import KEEP_THE_RANGE, obj_of, solved, warning_about


def squeezed(factor: float) -> Soup:
    """Every other column of a grid moved next to its neighbour: needles."""
    soup = grid(8, 8)
    positions = soup.positions.copy()
    odd = positions[:, 0] % 2 == 1
    positions[odd, 0] += 1 - factor
    return Soup(positions, soup.faces)


def caps(height: float) -> Soup:
    """Triangles with an angle of nearly 180°: every cell has a vertex just above the middle of its lower side."""
    soup = grid(6, 6)
    corner = [face[:2] for face in soup.faces[::2]]
    middle = np.array([(soup.positions[a] + soup.positions[b]) / 2 + [0, height, 0] for a, b in corner])
    faces = []
    for number, ((a, b), upper) in enumerate(zip(corner, soup.faces[1::2])):
        new, above, left = soup.size + number, upper[1], upper[2]
        faces += [[a, b, new], [b, above, new], [above, left, new], [left, a, new]]
    return Soup(np.vstack((soup.positions, middle)), faces)


def lantern(around: int, up: int) -> Soup:
    """Schwarz's: rings of a cylinder, each turned by half a step; its triangles turn inwards as `up` grows."""
    j, k = np.divmod(np.arange(around * (up + 1)), around)
    angle = 2 * np.pi * (k + j / 2) / around
    positions = np.column_stack((np.cos(angle), np.sin(angle), j / up))
    faces = []
    for ring in range(up):
        for a in range(around):
            low, high = ring * around, (ring + 1) * around
            faces += [
                [low + a, low + (a + 1) % around, high + a],
                [high + a, low + (a + 1) % around, high + (a + 1) % around],
            ]
    return Soup(positions, faces)


def collapsed_block() -> Soup:
    """A grid of which 3 × 3 vertices are at one place."""
    soup = grid(8, 8)
    positions = soup.positions.copy()
    block = [x + 9 * y for x in (3, 4, 5) for y in (3, 4, 5)]
    positions[block] = positions[block[4]]
    return Soup(positions, soup.faces)


BAD = {
    "needles of 1e-3": squeezed(1e-3), "needles of 1e-6": squeezed(1e-6), "needles of 1e-12": squeezed(1e-12),
    "zero area": squeezed(0), "caps of 1e-3": caps(1e-3), "caps of 1e-12": caps(1e-12), "flat caps": caps(0),
    "Schwarz lantern": lantern(8, 200), "collapsed block": collapsed_block(), "slivers": sphere(3, 200),
}  # fmt: skip
FLAT = {"zero area": 64, "flat caps": 36, "collapsed block": 16}


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("name", BAD)
def test_the_field_on_bad_triangles_is_finite_and_in_range(laplacian, name):
    soup = BAD[name]
    field, _ = solved(soup.mesh(), [0, soup.size - 1], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0
    if laplacian in KEEP_THE_RANGE:
        assert field.values.min() == 0
        assert field.values.max() == 1


@pytest.mark.parametrize("name", BAD)
def test_faces_without_area_are_counted_and_the_first_is_named(name):
    soup = BAD[name]
    triangles = soup.positions[np.array(soup.faces)]
    areas = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    defects = find_defects(soup.mesh())
    assert defects.flat_faces == np.count_nonzero(areas == 0) == FLAT.get(name, 0)
    if defects.flat_faces:
        message = warning_about("no area", defects.warnings)
        assert message.startswith(f"face {np.flatnonzero(areas == 0)[0]} has no area")
        assert f"{defects.flat_faces - 1} more faces" in message


def test_faces_without_area_are_told_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(BAD["zero area"]))
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [80]))
    assert "63 more" in warning_about("no area", output.splitlines())


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("positions", [np.zeros((25, 3)), grid(4, 4).positions * [1, 0, 0]], ids=["a point", "a line"])
def test_a_mesh_without_any_area_is_refused_for_it_but_the_graph_still_solves(laplacian, positions):
    mesh = Mesh(positions, grid(4, 4).faces)
    if laplacian in ("auto", "graph"):
        solved(mesh, [0, 24], [0.0, 1.0], laplacian)
    else:
        with pytest.raises(DirichletError, match="area"):
            solve(mesh, [0, 24], [0.0, 1.0], laplacian=laplacian)


def test_a_mesh_without_any_area_is_refused_for_it_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(Soup(grid(4, 4).positions * [1, 0, 0], grid(4, 4).faces)))
    words = [mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [24])]
    assert "none of the 32 faces has an area" in command.refuses(*words, "--laplacian", "cotangent")
    assert "has no area" in command.accepts(*words)
