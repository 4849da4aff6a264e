# SPDX-License-Identifier: GPL-3.0-or-later
"""Paint for the test meshes, and the paper's system solved anew with SciPy for comparison."""

from __future__ import annotations

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
from mesh_makers import Soup, adjacency


def random_paint(size: int, seed: int = 0, share: float = 0.2) -> tuple[np.ndarray, np.ndarray]:
    """Distinct vertices in no order, at least two of them, and values in [-3, 3]."""
    random = np.random.default_rng(seed)
    vertices = random.permutation(size)[: max(2, round(share * size))]
    return vertices, random.uniform(-3, 3, len(vertices))


def paper_matrix(soup: Soup, painted: np.ndarray) -> scipy.sparse.csr_matrix:
    """(I − M)(I − D⁻¹A) + M, equation (3) of the paper; a vertex without neighbours keeps an empty row."""
    A = adjacency(soup)
    valence = A.sum(axis=1).A1
    inverse = np.divide(1.0, valence, out=np.zeros(soup.size), where=valence > 0)
    L = scipy.sparse.diags((valence > 0).astype(float)) - scipy.sparse.diags(inverse) @ A
    m = np.zeros(soup.size)
    m[painted] = 1
    return scipy.sparse.csr_matrix(scipy.sparse.diags(1 - m) @ L + scipy.sparse.diags(m))


def reference_field(soup: Soup, painted, values, source=None) -> np.ndarray:
    """φ by a sparse LU factorisation of the paper's matrix; every connected piece has to have paint."""
    right = np.zeros(soup.size) if source is None else np.array(source, float)
    right[painted] = values
    return scipy.sparse.linalg.spsolve(paper_matrix(soup, painted).tocsc(), right)
