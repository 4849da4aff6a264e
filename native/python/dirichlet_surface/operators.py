# SPDX-License-Identifier: GPL-3.0-or-later
"""The matrices behind a field: stiffness K, lumped mass and the paper's square matrix, of any Laplacian."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, Reals, as_painted, require_name
from .mesh import Mesh, require_mesh

LAPLACIANS = {
    "graph": "the paper's: every neighbour counts alike, whatever the shape; works on any mesh",
    "cotangent": "follows the shape: for good triangles; obtuse ones may push values out of the painted range",
    "intrinsic_delaunay": "follows the shape and keeps the painted range on any mesh, slivers too",
    "polygon": "follows the shape of quads and n-gons and prefers no diagonal; the range as for cotangent",
    "auto": "cotangent or polygon where they keep the painted range, else what does; the report says why",
}
"""By name, when to take it."""


class CsrMatrix(NamedTuple):
    """A square sparse matrix in compressed rows; scipy.sparse.csr_matrix((data, indices, indptr)) takes its parts."""

    indptr: Indices
    """(n + 1,)"""
    indices: Indices
    """(nnz,) columns, ascending in every row"""
    data: NDArray[np.float64]
    """(nnz,)"""

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.indptr) - 1, len(self.indptr) - 1


def stiffness_matrix(mesh: Mesh, laplacian: str = "graph") -> CsrMatrix:
    """K (V, V) of one of LAPLACIANS: symmetric, positive semi-definite, rows sum to 0; every diagonal is stored.

    graph: D − A. cotangent: half the cotangents opposite to an edge, over mesh.triangles. intrinsic_delaunay: the same
    after intrinsic edge flips, so that no weight is negative. polygon: virtual vertices (Bunge et al. 2020). A triangle
    of a height below 1.5e-8 of its longest edge counts as one of that height.

    Raises InputError: no face has an area (graph needs none). Cost: O(V + corners); polygon: O(V + sum of corners²).
    """
    require_mesh(mesh)
    require_name(laplacian, LAPLACIANS, "Laplacian")
    return CsrMatrix(*_native.stiffness_matrix(mesh, laplacian))


def lumped_mass(mesh: Mesh, laplacian: str = "graph") -> Reals:
    """The diagonal (V,) of the mass matrix that goes with K: the Laplacian is mass⁻¹ K.

    graph: the number of neighbours. The others: areas, which sum to that of the surface. 0 at isolated vertices.
    Errors and cost as for stiffness_matrix.
    """
    require_mesh(mesh)
    require_name(laplacian, LAPLACIANS, "Laplacian")
    return _native.lumped_mass(mesh, laplacian)


def dirichlet_laplacian(mesh: Mesh, vertices: ArrayLike, laplacian: str = "graph") -> CsrMatrix:
    """The paper's square matrix (I − M) mass⁻¹ K + M for a painted set (C,): identity rows where painted.

    A free row without mass is scaled to a diagonal of 1; that of an isolated vertex is 0. Raises InputError: nothing
    painted, an index out of range, a mass whose inverse is not finite; and as stiffness_matrix.
    """
    require_mesh(mesh)
    require_name(laplacian, LAPLACIANS, "Laplacian")
    return CsrMatrix(*_native.dirichlet_laplacian(mesh, as_painted(vertices), laplacian))
