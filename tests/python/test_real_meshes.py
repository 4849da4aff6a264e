# SPDX-License-Identifier: GPL-3.0-or-later
"""The laws on scanned and modelled meshes, where these stand beside the repository."""

import numpy as np
import pytest
from dirichlet_surface import even_levels, isolines, read_mesh, solve
from isoline_laws import assert_sound
from numpy.testing import assert_allclose, assert_array_equal

SMALL = [
    "geometry-central__bob_small.ply",
    "geometry-central__dodecahedron_poly.obj",
    "geometry-central__moebius.obj",
    "geometry-central__hourglass_ico.obj",
    "odedstein__hand_lowres.obj",
    "odedstein__spot_control_mesh.obj",
    "odedstein__torus.obj",
    "odedstein__wingnut.obj",
    "polyLaplace__concave_3.obj",
    "polyLaplace__data__surface_meshes__sphere__voronoi_5.obj",
    "potpourri3d__bunny_poly.ply",
    "trimesh__multibody.stl",
]
LARGE = ["derived__dragon_28k.obj", "odedstein__sword-quad-dominant.obj", "common-3d__stanford-bunny.obj"]


def painted(mesh) -> tuple[np.ndarray, np.ndarray]:
    """Six vertices of every connected piece, or all of a smaller one."""
    labels, count = mesh.components()
    random = np.random.default_rng(0)
    pieces = (np.flatnonzero(labels == piece) for piece in range(count))
    vertices = np.concatenate([random.permutation(piece)[:6] for piece in pieces])
    return vertices, random.uniform(-1, 1, len(vertices))


@pytest.mark.parametrize("name", SMALL + LARGE)
def test_laws_of_field_and_isolines(real_mesh_folder, name):
    mesh = read_mesh(real_mesh_folder / name)
    vertices, values = painted(mesh)
    field = solve(mesh, vertices, values)
    assert_array_equal(field.values[vertices], values)
    assert values.min() <= field.values.min()
    assert field.values.max() <= values.max()
    assert field.report.undefined == 0
    assert_average_of_neighbours(mesh, vertices, field.values)
    on_faces = field.values[mesh.corners]  # lone vertices carry no line
    lines = isolines(mesh, field.values, even_levels(on_faces.min(), on_faces.max(), 13))
    assert_sound(mesh, field.values, lines)
    assert_array_equal(np.unique(lines.level), np.arange(13))


def assert_average_of_neighbours(mesh, vertices, values):
    first, second = mesh.edges.T
    valence = np.bincount(mesh.edges.ravel(), minlength=mesh.vertex_count)
    total = np.bincount(first, values[second], mesh.vertex_count) + np.bincount(
        second, values[first], mesh.vertex_count
    )
    free = np.ones(mesh.vertex_count, bool)
    free[vertices] = False
    assert_allclose((valence * values - total)[free], 0, atol=1e-10)


@pytest.mark.parametrize("name", SMALL)
def test_both_methods_agree(real_mesh_folder, name):
    mesh = read_mesh(real_mesh_folder / name)
    vertices, values = painted(mesh)
    direct, lscg = (solve(mesh, vertices, values, method=method).values for method in ("direct", "lscg"))
    assert_allclose(lscg, direct, rtol=0, atol=1e-8 * np.abs(values).max())
