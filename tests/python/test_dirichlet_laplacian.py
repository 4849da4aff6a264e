# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's square matrix, (I − M)(I − D⁻¹A) + M, entry by entry."""

import numpy as np
import pytest
import scipy.sparse
from dirichlet_surface import InputError, dirichlet_laplacian, solve
from mesh_makers import ZOO, Soup, grid, prism
from numpy.testing import assert_allclose, assert_array_equal
from paintings import paper_matrix, random_paint


def matrix_of(soup: Soup, painted) -> scipy.sparse.csr_matrix:
    csr = dirichlet_laplacian(soup.mesh(), painted)
    return scipy.sparse.csr_matrix((csr.data, csr.indices, csr.indptr), shape=csr.shape)


@pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
def test_it_is_equation_three_of_the_paper(soup):
    painted, _ = random_paint(soup.size)
    assert_allclose(matrix_of(soup, painted).toarray(), paper_matrix(soup, painted).toarray(), rtol=0, atol=1e-15)


def test_a_quad_with_one_painted_corner_by_hand():
    soup = Soup(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]]), [[0, 1, 2, 3]])
    expected = [[1, -0.5, 0, -0.5], [0, 1, 0, 0], [0, -0.5, 1, -0.5], [-0.5, 0, -0.5, 1]]  # no diagonal 0-2
    assert_array_equal(matrix_of(soup, [1]).toarray(), expected)


def test_painted_rows_are_identity_and_free_rows_sum_to_zero():
    soup = prism(9)
    painted, _ = random_paint(soup.size)
    dense = matrix_of(soup, painted).toarray()
    assert_array_equal(dense[painted], np.eye(soup.size)[painted])
    assert_allclose(np.delete(dense, painted, axis=0).sum(axis=1), 0, atol=1e-15)


def test_the_field_solves_it():
    soup = grid(6, 4)
    painted, values = random_paint(soup.size)
    right = np.zeros(soup.size)
    right[painted] = values
    assert_allclose(matrix_of(soup, painted) @ solve(soup.mesh(), painted, values).values, right, atol=1e-12)


def test_an_isolated_vertex_has_no_equation_unless_painted():
    soup = grid(1, 1)
    soup = Soup(np.vstack((soup.positions, [[5, 5, 5]])), soup.faces)
    assert not matrix_of(soup, [0])[4].toarray().any()
    assert_array_equal(matrix_of(soup, [4])[4].toarray(), [[0, 0, 0, 0, 1]])


def test_its_arrays_are_compressed_rows_with_ascending_columns():
    soup = grid(6, 4)
    csr = dirichlet_laplacian(soup.mesh(), [3])
    assert csr.shape == (soup.size, soup.size)
    assert csr.indptr.shape == (soup.size + 1,)
    assert csr.indptr[-1] == len(csr.indices) == len(csr.data)
    assert csr.indptr.dtype == csr.indices.dtype == np.int32
    assert csr.data.dtype == np.float64
    assert all((np.diff(csr.indices[a:b]) > 0).all() for a, b in zip(csr.indptr, csr.indptr[1:]))


def test_a_painted_vertex_outside_the_mesh_is_refused():
    with pytest.raises(InputError, match="99"):
        dirichlet_laplacian(grid(2, 2).mesh(), [0, 99])
