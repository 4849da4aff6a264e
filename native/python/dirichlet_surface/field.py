# SPDX-License-Identifier: GPL-3.0-or-later
"""Harmonic fields: Laplace's (or Poisson's) equation with values injected on painted vertices."""

from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._arrays import Indices, Reals, as_count, as_indices, as_reals, require_shape
from ._native import InputError
from .mesh import Mesh

LAPLACIANS = ("graph",)
METHODS = ("direct", "lscg")


@dataclass(frozen=True)
class SolveReport:
    """What was solved, how well and how fast. Ranges are over all columns of a field."""

    laplacian: str
    method: str
    vertices: int
    painted: int
    """distinct painted vertices"""
    unknowns: int
    """free vertices that have an equation"""
    nonzeros: int
    """of the injected matrix; direct: of its lower triangle"""
    factor_nonzeros: int
    iterations: int
    """0 for a direct method"""
    relative_residual: float
    """‖rhs − Kφ‖ / ‖rhs‖ over the free vertices, the worst column"""
    minimum: float
    maximum: float
    painted_minimum: float
    painted_maximum: float
    outside: int
    """values that rounding left outside the painted range of their region and that were projected onto it"""
    farthest_outside: float
    undefined: int
    """vertices of pieces without paint: NaN"""
    first_undefined: int
    """the lowest of them, or -1"""
    seconds: dict[str, float]
    """wall time of connectivity, laplacian, injection, factorisation and solve"""
    warnings: tuple[str, ...]

    def summary(self) -> str:
        """One line for people."""
        milliseconds = 1000 * sum(self.seconds.values())
        return (
            f"{self.unknowns} of {self.vertices} vertices solved in {milliseconds:.1f} ms, "
            f"values {self.minimum:.6g} to {self.maximum:.6g}, relative residual {self.relative_residual:.1e}"
        )

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers, strings, lists and dictionaries, ready for JSON."""
        return asdict(self) | {"warnings": list(self.warnings)}


@dataclass(frozen=True)
class Field:
    """A solved field: values (V,), NaN on connected pieces without paint, and the report."""

    values: Reals
    report: SolveReport


class HarmonicSolver:
    """Factors the problem once for a mesh and its painted vertices, then solves any values.

    mesh            what is painted; only its matrix is kept
    vertices        (C,) painted vertices, any order; a repeated one has to be given equal values
    laplacian       "graph": the paper's, I − D⁻¹A over the polygon edges
    method          "direct": Cholesky of the symmetric twin; "lscg": the paper's least-squares conjugate gradients on
                    the raw matrix, the reference
    tolerance       lscg alone: stop at ‖Aᵀr‖ ≤ tolerance ‖Aᵀb‖, in (0, 1)
    max_iterations  lscg alone: at least 1

    Raises InputError (nothing painted, an index or option out of range) or SolverError.
    """

    def __init__(
        self,
        mesh: Mesh,
        vertices: ArrayLike,
        *,
        laplacian: str = "graph",
        method: str = "direct",
        tolerance: float | None = None,
        max_iterations: int | None = None,
    ) -> None:
        for name, kinds, what in ((laplacian, LAPLACIANS, "Laplacian"), (method, METHODS, "method")):
            if name not in kinds:
                raise InputError(f"there is no {what} {name!r}; choose from: {', '.join(kinds)}")
        painted = as_indices(vertices, "painted vertices")
        require_shape(painted, (None,), "painted vertices")
        if max_iterations is not None:
            max_iterations = as_count(max_iterations, "max_iterations", 2**31 - 1)
        self._choice: dict[str, Any] = {"laplacian": laplacian, "method": method}
        self._native = _native.HarmonicSolver(mesh, painted, method == "direct", tolerance, max_iterations)
        self._report: SolveReport | None = None

    def solve(self, values: ArrayLike, source: ArrayLike | None = None) -> Reals:
        """The field for painted values (C,) or (C, k), aligned with the vertices: (V,) or (V, k).

        source  (V,) or nothing: at free vertices (I − D⁻¹A) φ = source, so a positive source raises φ; entries at
                painted vertices are not read.

        φ equals the painted values bit for bit where painted, and is NaN on connected pieces without paint. Raises
        InputError (a length, a number that is not finite, one vertex with two values) or SolverError. Releases the GIL.
        """
        columns = as_reals(values, "painted values")
        if columns.ndim not in (1, 2):
            raise InputError(f"painted values have the shape {columns.shape}, but have to be (C,) or (C, k)")
        forcing = None
        if source is not None:
            forcing = as_reals(source, "sources")
            require_shape(forcing, (None,), "sources")
        field, report = self._native.solve(columns[:, None] if columns.ndim == 1 else columns, forcing)
        self._report = SolveReport(**self._choice, **report)
        return field[:, 0] if columns.ndim == 1 else field

    @property
    def report(self) -> SolveReport:
        """Of the last solve."""
        if self._report is None:
            raise InputError("nothing was solved yet, so there is no report")
        return self._report


def solve(
    mesh: Mesh,
    vertices: ArrayLike,
    values: ArrayLike,
    *,
    laplacian: str = "graph",
    method: str = "direct",
    source: ArrayLike | None = None,
    tolerance: float | None = None,
    max_iterations: int | None = None,
) -> Field:
    """The field (V,) that has `values` (C,) at `vertices` (C,) and is harmonic everywhere else; see HarmonicSolver."""
    solver = HarmonicSolver(
        mesh, vertices, laplacian=laplacian, method=method, tolerance=tolerance, max_iterations=max_iterations
    )
    numbers = as_reals(values, "painted values")
    require_shape(numbers, (None,), "painted values")
    return Field(solver.solve(numbers, source), solver.report)


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


def dirichlet_laplacian(mesh: Mesh, vertices: ArrayLike) -> CsrMatrix:
    """The paper's square matrix (I − M)(I − D⁻¹A) + M for a painted set (C,): identity rows where painted.

    Raises InputError: nothing painted, an index out of range. Cost: O(V + E).
    """
    painted = as_indices(vertices, "painted vertices")
    require_shape(painted, (None,), "painted vertices")
    return CsrMatrix(*_native.dirichlet_laplacian(mesh, painted))
