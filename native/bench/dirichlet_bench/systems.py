# SPDX-License-Identifier: GPL-3.0-or-later
"""The linear systems of a painting; peers/system.h is the same for C++. Upper triangles in compressed rows, which are
lower ones in compressed columns."""

import numpy as np
import scipy.sparse
from numpy.typing import NDArray

Reals = NDArray[np.float64]


def whole(lower: scipy.sparse.csc_matrix) -> scipy.sparse.csr_matrix:
    """Both triangles."""
    return (lower + scipy.sparse.tril(lower, -1).T).tocsr()


def right_side(lower: scipy.sparse.csc_matrix, painting: Reals) -> Reals:
    """(V,) painted values where painted, what they do to their neighbours where free."""
    values = np.nan_to_num(painting)
    return np.where(np.isnan(painting), -(whole(lower) @ values), values)


def reduce(lower: scipy.sparse.csc_matrix, painting: Reals) -> tuple[scipy.sparse.csr_matrix, Reals]:
    """The free vertices alone, the smallest system: what a cold solve wants."""
    free = np.flatnonzero(np.isnan(painting))
    return lower[:, free][free].T.tocsr(), right_side(lower, painting)[free]


def inject(lower: scipy.sparse.csc_matrix, painting: Reals) -> tuple[scipy.sparse.csr_matrix, Reals]:
    """Painted vertices as identity rows, in the pattern of the mesh: one analysis then serves every painting."""
    free = np.isnan(painting)
    columns = np.repeat(np.arange(len(free)), np.diff(lower.indptr))
    values = np.where(free[lower.indices] & free[columns], lower.data, np.where(lower.indices == columns, 1.0, 0.0))
    injected = scipy.sparse.csc_matrix((values, lower.indices, lower.indptr), lower.shape)
    return injected.T.tocsr(copy=False), right_side(lower, painting)
