# SPDX-License-Identifier: GPL-3.0-or-later
"""Geodesic discs as Python sees them; their geometry is checked in C++."""

import numpy as np
import pytest
from dirichlet_surface import InputError, geodesic_disc
from mesh_makers import ZOO, grid, joined, sphere
from numpy.testing import assert_allclose, assert_array_equal


@pytest.mark.parametrize("name", ZOO)
@pytest.mark.parametrize("radius", [0.0, 0.8, np.inf])
def test_a_disc_is_vertices_in_order_with_their_distances(name, radius):
    soup = ZOO[name]
    vertices, distances = geodesic_disc(soup.mesh(), soup.positions[1], radius)
    assert (vertices.dtype, distances.dtype) == (np.int32, np.float64)
    assert vertices.shape == distances.shape
    assert (np.diff(vertices) > 0).all()
    assert 1 in vertices
    assert (distances <= radius).all()
    assert (distances >= np.linalg.norm(soup.positions[vertices] - soup.positions[1], axis=1) * (1 - 1e-15)).all()
    assert radius < np.inf or len(vertices) == soup.size


def test_on_a_plane_it_is_round():
    soup = grid(12, 9, triangles=False)
    vertices, distances = geodesic_disc(soup.mesh(), [4.3, 5.2, 7.0], 3, face=None)  # 7 above the surface
    expected = np.linalg.norm(soup.positions - [4.3, 5.2, 0], axis=1)
    assert_array_equal(vertices, np.flatnonzero(expected <= 3))
    assert_allclose(distances, expected[vertices], rtol=1e-12)


def test_a_face_says_on_which_of_two_sheets_the_middle_lies():
    soup = joined(grid(4, 4), grid(4, 4))
    soup = soup._replace(positions=np.vstack((soup.positions[:25], soup.positions[:25])))
    assert geodesic_disc(soup.mesh(), [2, 2, 0], np.inf, face=0)[0].max() == 24
    assert geodesic_disc(soup.mesh(), [0, 0, 0], np.inf, face=np.int64(32))[0].min() == 25


@pytest.mark.parametrize(
    ("point", "radius", "face"),
    [
        ([0, 0, np.nan], 1, None),
        ([0, 0], 1, None),
        ([0, 0, 0], -1, None),
        ([0, 0, 0], np.nan, None),
        ([0, 0, 0], "1", None),
        ([0, 0, 0], None, None),
        ([0, 0, 0], 1, 10**12),
        ([0, 0, 0], 1, -1),
        ([0, 0, 0], 1, 0.5),
    ],
)
def test_what_is_no_disc_is_refused(point, radius, face):
    with pytest.raises(InputError):
        geodesic_disc(sphere(5, 7).mesh(), point, radius, face)


def test_what_is_no_mesh_is_refused():
    with pytest.raises(InputError, match="needs a Mesh"):
        geodesic_disc(np.zeros((3, 3)), [0, 0, 0], 1)
