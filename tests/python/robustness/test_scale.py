# SPDX-License-Identifier: GPL-3.0-or-later
"""Size, place and stretch of a mesh: the same field, since nothing knows an absolute tolerance."""

import numpy as np
import pytest
from dirichlet_surface import find_defects, isolines
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import Soup, joined, sphere, torus
from outcomes import obj_of, solved

SPHERE = sphere(7, 10)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("scale", [1e-160, 1e-100, 1e-20, 1e20, 1e100, 1e150])
def test_size_does_not_change_the_field_nor_its_lines(laplacian, scale):
    field, lines = solved(SPHERE.mesh(), [0, 71], [0.0, 1.0], laplacian)
    scaled = Soup(SPHERE.positions * scale, SPHERE.faces).mesh()
    field_scaled, lines_scaled = solved(scaled, [0, 71], [0.0, 1.0], laplacian)
    np.testing.assert_allclose(field_scaled.values, field.values, rtol=0, atol=1e-9)
    np.testing.assert_array_equal(lines_scaled.closed, lines.closed)
    np.testing.assert_allclose(lines_scaled.length / scale, lines.length, rtol=1e-6)
    assert find_defects(scaled).warnings == ()


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("offset", [1e6, 1e9, 1e13])
def test_place_changes_the_field_by_no_more_than_the_coordinates_are_rounded(laplacian, offset):
    field, _ = solved(SPHERE.mesh(), [0, 71], [0.0, 1.0], laplacian)
    moved, lines = solved(Soup(SPHERE.positions + offset, SPHERE.faces).mesh(), [0, 71], [0.0, 1.0], laplacian)
    rounding = 0 if laplacian == "graph" else 8 * np.spacing(offset)  # of the radius 1
    painted_range = 1.0
    np.testing.assert_allclose(moved.values, field.values, rtol=0, atol=painted_range * (1e-12 + rounding))
    assert lines.closed.all()


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("stretch", [1e-6, 1e6])
def test_stretched_surfaces_are_solved(laplacian, stretch):
    soup = torus(12, 7)
    field, lines = solved(Soup(soup.positions * [1, 1, stretch], soup.faces).mesh(), [0, 40], [0.0, 1.0], laplacian)
    assert lines.closed.all()
    assert field.report.undefined == 0


@pytest.mark.parametrize("scale", ["1e-160", "1e150"])
def test_size_does_not_matter_on_the_command_line(command, scale):
    mesh = command.write("mesh.obj", obj_of(Soup(SPHERE.positions * float(scale), SPHERE.faces)))
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [71]), "--isolines", "7")
    assert "7 on 7 levels, 7 closed, 0 open" in output
    assert "warning" not in output


@pytest.mark.parametrize("scale", [5e-324, 1e-300, 1e300, 1.7e308])
def test_the_size_of_the_values_does_not_matter(scale):
    mesh = SPHERE.mesh()
    field, _ = solved(mesh, [0, 71], [0.0, scale])
    assert field.report.maximum == scale
    assert len(isolines(mesh, field.values, [scale / 2])) == (scale > 5e-324)


@pytest.mark.parametrize(("huge", "tiny"), [(1e300, 1e-30), (1e200, 1e-80), (1e-200, 1e-300)])
def test_pieces_of_far_apart_values_keep_their_digits(huge, tiny):
    two = joined(SPHERE, Soup(SPHERE.positions + 9, SPHERE.faces))
    field, _ = solved(two.mesh(), [0, 71, 72, 143], [0.0, huge, tiny, 3 * tiny])
    alone, _ = solved(SPHERE.mesh(), [0, 71], [0.0, 1.0])
    np.testing.assert_allclose(field.values[:72] / huge, alone.values, rtol=0, atol=1e-12)
    np.testing.assert_allclose(field.values[72:] / tiny, 1 + 2 * alone.values, rtol=0, atol=1e-12)
