# SPDX-License-Identifier: GPL-3.0-or-later
"""What paint does not reach has no value, is told in one line, and disturbs nothing."""

import numpy as np
import pytest
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import Soup, joined, sphere, tetrahedron
from outcomes import obj_of, solved, warning_about

SPHERE = sphere(7, 10)
WITH_LONE_VERTICES = Soup(np.vstack((SPHERE.positions, [[5, 5, 5], [6, 6, 6]])), SPHERE.faces)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_lone_vertices_have_no_value_and_are_told_in_one_line(laplacian):
    field, lines = solved(WITH_LONE_VERTICES.mesh(), [0, 71], [0.0, 1.0], laplacian)
    assert np.isnan(field.values[72:]).all()
    assert lines.closed.all()
    message = warning_about("without paint", field.report.warnings)
    assert message.startswith("2 vertices")
    assert "the first is vertex 72" in message
    np.testing.assert_array_equal(field.values[:72], solved(SPHERE.mesh(), [0, 71], [0.0, 1.0], laplacian)[0].values)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_painted_lone_vertex_keeps_its_value(laplacian):
    field, _ = solved(WITH_LONE_VERTICES.mesh(), [0, 71, 73], [0.0, 1.0, 0.5], laplacian)
    assert field.values[73] == 0.5
    assert field.report.undefined == 1


def test_loose_edges_of_a_file_are_passed_over(command):
    content = obj_of(WITH_LONE_VERTICES) + "l 73 74\nl 1 73\np 74\n"
    mesh = command.write("mesh.obj", content)
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [71]))
    assert "warning: 2 vertices lie on pieces without paint" in output


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize(("painted", "pieces"), [(1, 2), (450, 900), (899, 900)])
def test_any_number_of_pieces_without_paint_is_told_in_one_line(laplacian, painted, pieces):
    mesh = joined(*[tetrahedron()] * pieces).mesh()
    low = 4 * np.arange(painted)
    field, lines = solved(mesh, np.concatenate((low, low + 1)), np.repeat([0.0, 1.0], painted), laplacian)
    assert field.report.undefined == 4 * (pieces - painted)
    assert len(lines) == 7 * painted
    assert f"vertex {4 * painted}" in warning_about("without paint", field.report.warnings)


def test_pieces_without_paint_are_told_in_one_line_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(joined(*[tetrahedron()] * 900)))
    low = range(0, 1800, 4)
    output = command.accepts(
        mesh, *command.paint("low", 0, low), *command.paint("high", 1, [v + 1 for v in low]), "--out-lines", "lines.obj"
    )
    assert "1800 of 3600" not in output
    assert "warning: 1800 vertices lie on pieces without paint" in output
    assert output.count("warning") == 1
