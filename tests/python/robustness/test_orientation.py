# SPDX-License-Identifier: GPL-3.0-or-later
"""Which way faces run has no say in the field; lines close on every closed surface, one-sided ones too."""

import numpy as np
import pytest
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import Soup, moebius, sphere, torus
from outcomes import obj_of, solved


def turned_over(soup: Soup, step: int) -> Soup:
    return Soup(soup.positions, [face[::-1] if f % step == 0 else face for f, face in enumerate(soup.faces)])


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("step", [1, 2, 3])
@pytest.mark.parametrize("soup", [sphere(7, 10), torus(12, 7, triangles=False)], ids=["triangles", "quads"])
def test_flipped_faces_leave_the_field_and_close_their_lines(laplacian, soup, step):
    field, _ = solved(soup.mesh(), [0, 40], [0.0, 1.0], laplacian)
    flipped, lines = solved(turned_over(soup, step).mesh(), [0, 40], [0.0, 1.0], laplacian)
    np.testing.assert_allclose(flipped.values, field.values, rtol=0, atol=1e-12)
    assert lines.closed.all()


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("triangles", [True, False], ids=["triangles", "quads"])
def test_lines_on_a_klein_bottle_close(laplacian, triangles):
    field, lines = solved(torus(12, 7, triangles, klein=True).mesh(), [0, 40], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0
    assert len(lines) >= 7
    assert lines.closed.all()


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_lines_on_a_moebius_band_close_or_end_on_its_border(laplacian):
    field, lines = solved(moebius(11).mesh(), [0, 11], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0
    assert len(lines) >= 7


def test_one_sided_surfaces_are_solved_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(torus(12, 7, klein=True)))
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [40]))
    assert ", 0 open" in output
    assert "warning" not in output
