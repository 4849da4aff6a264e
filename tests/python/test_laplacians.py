# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of the stiffness and mass matrices, whatever the Laplacian."""

import numpy as np
import pytest
from dirichlet_surface import LAPLACIANS, InputError, TopologyError, dirichlet_laplacian, lumped_mass, stiffness_matrix
from laplacians import GEOMETRIC, cotangent_reference, mass, pentagram, polygon_reference, rotated, shaken, stiffness
from mesh_makers import ZOO, Soup, adjacency, grid, joined, moebius, prism, renumbered, sphere, torus
from numpy.testing import assert_allclose, assert_array_equal

everywhere = pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
every_laplacian = pytest.mark.parametrize("laplacian", LAPLACIANS)
geometric = pytest.mark.parametrize("laplacian", GEOMETRIC)

TRIANGLES = {name: soup for name, soup in ZOO.items() if all(len(face) == 3 for face in soup.faces)}
POLYGONS = {
    "quad cylinder": ZOO["quad cylinder"],
    "prism": prism(9),
    "Möbius band of bent quads": moebius(11),
    "torus of quads": torus(9, 7, triangles=False),
    "hollow quads": shaken(grid(6, 6, triangles=False), 0.45),
    "bent octagon": Soup(prism(8).positions[:8] + np.random.default_rng(8).uniform(-0.2, 0.2, (8, 3)), [[*range(8)]]),
}


def energy_scale(K) -> float:
    return abs(K).max()


@everywhere
@every_laplacian
def test_stiffness_is_symmetric_positive_semi_definite_and_its_rows_sum_to_zero(soup, laplacian):
    K = stiffness(soup, laplacian)
    assert_array_equal(K.toarray(), K.toarray().T)
    assert abs(K.sum(axis=1)).max() <= 1e-14 * energy_scale(K)
    eigenvalues = np.linalg.eigvalsh(K.toarray())
    assert eigenvalues[0] >= -1e-14 * soup.size * energy_scale(K)
    assert eigenvalues[1] > 1e-6 * energy_scale(K)  # constants alone cost nothing


@everywhere
@every_laplacian
def test_columns_ascend_in_every_row_and_every_diagonal_is_stored(soup, laplacian):
    csr = stiffness_matrix(soup.mesh(), laplacian)
    for row, (a, b) in enumerate(zip(csr.indptr, csr.indptr[1:])):
        assert (np.diff(csr.indices[a:b]) > 0).all()
        assert row in csr.indices[a:b]


@everywhere
def test_graph_stiffness_is_valence_minus_adjacency_and_its_mass_the_valence(soup):
    A = adjacency(soup)
    assert_array_equal(stiffness(soup, "graph").toarray(), np.diag(A.sum(axis=1).A1) - A)
    assert_array_equal(mass(soup, "graph"), A.sum(axis=1).A1)


@pytest.mark.parametrize("soup", TRIANGLES.values(), ids=TRIANGLES.keys())
def test_cotangents_are_half_the_cotangents_opposite_to_every_edge(soup):
    expected = cotangent_reference(soup)
    assert_allclose(stiffness(soup, "cotangent").toarray(), expected, rtol=0, atol=1e-13 * abs(expected).max())


@pytest.mark.parametrize("soup", TRIANGLES.values(), ids=TRIANGLES.keys())
def test_polygon_equals_cotangent_on_triangles(soup):
    K = stiffness(soup, "cotangent")
    assert abs(stiffness(soup, "polygon") - K).max() <= 1e-14 * energy_scale(K)
    assert_allclose(mass(soup, "polygon"), mass(soup, "cotangent"), rtol=1e-14)


@pytest.mark.parametrize("soup", POLYGONS.values(), ids=POLYGONS.keys())
def test_polygon_is_that_of_the_virtual_vertex_of_least_areas(soup):
    K, lumped = polygon_reference(soup)
    assert_allclose(stiffness(soup, "polygon").toarray(), K, rtol=0, atol=1e-11 * abs(K).max())
    if (lumped > 0).all() and soup is not POLYGONS["hollow quads"]:
        assert_allclose(mass(soup, "polygon"), lumped, rtol=1e-11)


def test_a_square_by_hand():
    square = Soup(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]]), [[0, 1, 2, 3]])
    assert_allclose(stiffness(square, "polygon").toarray(), np.eye(4) - 0.25, atol=1e-15)
    assert_allclose(mass(square, "polygon"), 0.25, rtol=1e-15)
    expected = [[1, -0.5, 0, -0.5], [-0.5, 1, -0.5, 0], [0, -0.5, 1, -0.5], [-0.5, 0, -0.5, 1]]
    assert_allclose(stiffness(square, "cotangent").toarray(), expected, atol=1e-15)
    assert_allclose(mass(square, "cotangent"), [1 / 3, 1 / 6, 1 / 3, 1 / 6], rtol=1e-15)


def triangle_area(soup: Soup) -> float:
    mesh = soup.mesh()
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


@pytest.mark.parametrize("laplacian", ["cotangent", "intrinsic_delaunay"])
@everywhere
def test_masses_are_not_negative_and_sum_to_the_area(soup, laplacian):
    lumped = mass(soup, laplacian)
    assert lumped.min() >= 0
    assert_allclose(lumped.sum(), triangle_area(soup), rtol=1e-13)


@pytest.mark.parametrize("amount", [0.0, 0.2, 0.45])
@geometric
def test_masses_sum_to_the_area_of_hollow_polygons_too(laplacian, amount):
    soup = rotated(shaken(grid(8, 5, triangles=False), amount))
    lumped = mass(soup, laplacian)
    assert lumped.min() >= 0
    assert_allclose(lumped.sum(), triangle_area(soup), rtol=1e-13)


def test_a_hollow_polygon_that_no_point_sees_whole_keeps_its_area():
    comb = [[0, 0], [5, 0], [5, 3], [4, 3], [4, 1], [3, 1], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]]
    soup = Soup(np.column_stack((comb, np.zeros(12))), [list(range(12))])
    for laplacian in GEOMETRIC:
        assert_allclose(mass(soup, laplacian).sum(), 5 + 3 * 2, rtol=1e-13)
        assert mass(soup, laplacian).min() >= 0


@pytest.mark.parametrize("size", [1e-150, 1e-60, 3e-5, 1e60, 1e140])
@geometric
@everywhere
def test_stiffness_does_not_see_the_scale_and_mass_is_its_square(soup, laplacian, size):
    scaled = Soup(soup.positions * size, soup.faces)
    K = stiffness(soup, laplacian)
    assert abs(stiffness(scaled, laplacian) - K).max() <= 1e-12 * energy_scale(K)
    if size > 1e-100:
        assert_allclose(mass(scaled, laplacian), mass(soup, laplacian) * size**2, rtol=1e-12)


@geometric
@everywhere
def test_stiffness_does_not_see_an_offset(soup, laplacian):
    moved = Soup(soup.positions + np.array([1e6, -3e6, 2e6]), soup.faces)
    K = stiffness(soup, laplacian)
    assert abs(stiffness(moved, laplacian) - K).max() <= 1e-7 * energy_scale(K)


def test_what_rounding_adds_to_a_slanted_plane_moves_no_virtual_vertex():
    soup = rotated(shaken(grid(6, 5, triangles=False), 0.3))
    moved = Soup(soup.positions + np.array([1e6, -3e6, 2e6]), soup.faces)
    K = stiffness(soup, "polygon")
    assert abs(stiffness(moved, "polygon") - K).max() <= 1e-6 * energy_scale(K)
    single = Soup(soup.positions.astype(np.float32).astype(float), soup.faces)  # as a host may store it
    assert abs(stiffness(single, "polygon") - K).max() <= 1e-5 * energy_scale(K)


def test_a_folded_polygon_has_no_negative_mass():
    random = np.random.default_rng(7)
    for _ in range(500):
        hexagon = Soup(random.normal(size=(6, 3)), [list(range(6))])
        assert (mass(hexagon, "polygon") >= 0).all()


@everywhere
@geometric
@pytest.mark.parametrize("change", ["face order", "face rotation", "winding", "every other winding"])
def test_how_faces_are_written_does_not_change_the_operator(soup, laplacian, change):
    triangles = soup.mesh().triangles.tolist()  # a diagonal may depend on where a quad begins
    faces = soup.faces if laplacian == "polygon" else triangles
    changed = {
        "face order": faces[::-1],
        "face rotation": [face[1:] + face[:1] for face in faces],
        "winding": [face[::-1] for face in faces],
        "every other winding": [face[:: 1 - 2 * (k % 2)] for k, face in enumerate(faces)],
    }[change]
    K = stiffness(Soup(soup.positions, faces), laplacian)
    assert abs(stiffness(Soup(soup.positions, changed), laplacian) - K).max() <= 1e-13 * energy_scale(K)


@everywhere
@geometric
def test_numbering_the_vertices_anew_renumbers_the_operator(soup, laplacian):
    faces = soup.faces if laplacian == "polygon" else soup.mesh().triangles.tolist()
    soup = Soup(soup.positions, faces)
    number = np.random.default_rng(4).permutation(soup.size)
    K, L = stiffness(soup, laplacian), stiffness(renumbered(soup, number), laplacian)
    assert abs(L[number][:, number] - K).max() <= 1e-13 * energy_scale(K)


@every_laplacian
def test_the_papers_matrix_is_the_operator_with_identity_rows_where_painted(laplacian):
    soup = ZOO["quad cylinder"]
    painted = [3, 7, 20]
    csr = dirichlet_laplacian(soup.mesh(), painted, laplacian)
    L = stiffness(soup, laplacian).toarray() / mass(soup, laplacian)[:, None]
    L[painted] = np.eye(soup.size)[painted]
    assert_array_equal(csr.indptr.shape, (soup.size + 1,))
    dense = np.zeros_like(L)
    for row, (a, b) in enumerate(zip(csr.indptr, csr.indptr[1:])):
        dense[row, csr.indices[a:b]] = csr.data[a:b]
    assert_allclose(dense, L, rtol=1e-14, atol=0)


@geometric
def test_an_isolated_vertex_has_no_mass_and_no_equation(laplacian):
    soup = grid(3, 3)
    soup = Soup(np.vstack((soup.positions, [[9, 9, 9]])), soup.faces)
    assert mass(soup, laplacian)[-1] == 0
    assert stiffness(soup, laplacian)[-1].toarray().max() == 0


@geometric
def test_a_row_without_mass_keeps_its_equation_at_a_diagonal_of_one(laplacian):
    soup = grid(3, 3)
    soup = Soup(np.vstack((soup.positions, [[-1, 0, 0]])), [*soup.faces, [16, 0, 1]])  # on a line
    csr = dirichlet_laplacian(soup.mesh(), [15], laplacian)
    row = dict(zip(csr.indices[csr.indptr[16] :], csr.data[csr.indptr[16] :]))
    assert row[16] == 1
    assert_allclose(sum(row.values()), 0, atol=1e-12)


@geometric
def test_masses_too_small_for_an_inverse_are_refused(laplacian):
    soup = grid(3, 3)
    with pytest.raises(InputError, match=r"vertex \d+ has a mass of .* larger scale"):
        dirichlet_laplacian(Soup(soup.positions * 1e-160, soup.faces).mesh(), [0], laplacian)


@geometric
def test_a_mesh_without_area_is_refused_for_want_of_area(laplacian):
    flat = Soup(np.array([[0, 0, 0], [1, 1, 1], [2, 2, 2], [0, 0, 0.0]]), [[0, 1, 2], [0, 3, 1], [0, 1, 2, 3]])
    for function in (stiffness_matrix, lumped_mass):
        with pytest.raises(InputError, match="none of the 3 faces has an area"):
            function(flat.mesh(), laplacian)
    assert stiffness(flat, "graph").shape == (4, 4)


def test_a_polygon_that_crosses_itself_needs_no_triangles_for_the_polygon_laplacian():
    soup = joined(grid(2, 2, triangles=False), pentagram())
    assert np.isfinite(stiffness(soup, "polygon").data).all()
    for laplacian in ("cotangent", "intrinsic_delaunay"):
        with pytest.raises(TopologyError, match="face 4 crosses itself"):
            stiffness_matrix(soup.mesh(), laplacian)


def test_a_polygon_of_many_corners_is_one_block():
    angle = 2 * np.pi * np.arange(400) / 400
    soup = Soup(np.column_stack((np.cos(angle), np.sin(angle), 0 * angle)), [list(range(400))])
    K = stiffness(soup, "polygon")
    assert K.nnz == 400**2
    assert_allclose(mass(soup, "polygon").sum(), 200 * np.sin(2 * np.pi / 400), rtol=1e-12)


def test_a_laplacian_that_there_is_not_is_refused_with_those_that_there_are():
    mesh = sphere(3, 5).mesh()
    for call in (lambda: stiffness_matrix(mesh, "mesh"), lambda: lumped_mass(mesh, "mesh")):
        with pytest.raises(InputError, match="no Laplacian 'mesh'; choose from: graph, cotangent, intrinsic_delaunay"):
            call()
