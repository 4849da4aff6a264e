# SPDX-License-Identifier: GPL-3.0-or-later
"""Harmonic fields: Laplace's (or Poisson's) equation with values injected on painted vertices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

from numpy.typing import ArrayLike

from . import _native
from ._arrays import Reals, as_count, as_painted, as_real, as_reals, require_name, require_shape
from ._native import InputError
from .cancel import CancelToken, as_token
from .mesh import Mesh, require_mesh
from .operators import LAPLACIANS

METHODS = ("auto", "direct", "multigrid", "lscg")
PRECISIONS = ("float64", "float32")


@dataclass(frozen=True)
class SolveReport:
    """What was solved, how well and how fast. Ranges are over all columns of a field."""

    laplacian: str
    """the one taken, never "auto\""""
    reason: str
    """one sentence: why "auto" took it; else empty"""
    flat_faces: int
    """faces without an area; 0 for the graph Laplacian"""
    method: str
    """the one taken, never "auto\""""
    update: str
    """what the last painting took, given the one before: "nothing", "values", "partial" or "full" factorisation"""
    repeated: float
    """its share of the work of a whole factorisation, 0 to 1"""
    vertices: int
    painted: int
    """distinct painted vertices"""
    unknowns: int
    """free vertices that have an equation"""
    nonzeros: int
    """of the square matrix"""
    factor_nonzeros: int
    """numbers stored for the factor; 0 for an iterative method"""
    iterations: int
    """0 for a direct method in float64"""
    relative_residual: float
    """‖rhs − Kφ‖ / ‖rhs‖ over the free vertices, the worst column"""
    minimum: float
    maximum: float
    painted_minimum: float
    painted_maximum: float
    outside: int
    """values outside the painted range of their region (looked for without a source). With a Laplacian that keeps the
    range, those by more than 64 ulp, where rounding left them: all are moved into it; else they stay, and a warning
    says so"""
    farthest_outside: float
    undefined: int
    """vertices of pieces without paint: NaN"""
    first_undefined: int
    """the lowest of them, or -1"""
    seconds: dict[str, float]
    """wall time: connectivity, laplacian and analysis, which are 0 after the first `paint`; injection and
    factorisation of the last change of paint; solve"""
    warnings: tuple[str, ...]

    def summary(self) -> str:
        """One line for people."""
        without = f" ({self.undefined} without a value)" if self.undefined else ""
        return (
            f"{self.unknowns} of {self.vertices} vertices solved{without} in {1000 * self.total_seconds:.1f} ms, "
            f"values {self.minimum:.6g} to {self.maximum:.6g}, relative residual {self.relative_residual:.1e}"
        )

    @property
    def total_seconds(self) -> float:
        """From arrays to the field for the first painting of a mesh, from one painting to the next afterwards."""
        return sum(self.seconds.values())

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers, strings, lists and dictionaries, ready for JSON."""
        return asdict(self) | {"warnings": list(self.warnings)}


@dataclass(frozen=True)
class Field:
    """A solved field: values (V,), NaN on connected pieces without paint, and the report."""

    values: Reals
    report: SolveReport


class HarmonicSolver:
    """Lives with a mesh: orders and analyses its matrix once, then follows the paint and the values.

    mesh            what is painted; only its matrix is kept
    vertices        (C,) painted vertices for `solve`, any order; or nothing yet
    laplacian       "graph": the paper's, I − D⁻¹A over the polygon edges; or another of LAPLACIANS
    method          "direct": Cholesky of the symmetric twin; "multigrid": conjugate gradients with memory O(V);
                    "auto": direct where the factor fits the memory budget, else multigrid; "lscg": the paper's
                    least-squares conjugate gradients on the raw matrix, the reference
    precision       of the direct method's factor: "float64", or "float32" at half the memory, refined to the tolerance
    memory_budget   bytes for the factor and what makes strokes quick; nothing said: half of the machine's memory
    tolerance       in (0, 1); float32 and multigrid stop at ‖r‖ ≤ tolerance ‖b‖ (nothing said: 1e-10), lscg at
                    ‖Aᵀr‖ ≤ tolerance ‖Aᵀb‖ (nothing said: 1e-14)
    max_iterations  of the same; at least 1
    cancel          a CancelToken by which another thread may stop what the solver is at, within a fraction of a second
                    (lscg: between columns): CancelledError. A new painting, once the token is reset, finds it usable.

    May be used from several threads. Raises InputError (nothing painted, an index or option out of range) or
    SolverError.
    """

    def __init__(
        self,
        mesh: Mesh,
        vertices: ArrayLike | None = None,
        *,
        laplacian: str = "graph",
        method: str = "auto",
        precision: str = "float64",
        memory_budget: int | None = None,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        cancel: CancelToken | None = None,
    ) -> None:
        require_mesh(mesh)
        for name, kinds, what in (
            (laplacian, LAPLACIANS, "Laplacian"),
            (method, METHODS, "method"),
            (precision, PRECISIONS, "precision"),
        ):
            require_name(name, kinds, what)
        if memory_budget is not None:
            memory_budget = as_count(memory_budget, "memory_budget", 2**63 - 1)
        if max_iterations is not None:
            max_iterations = as_count(max_iterations, "max_iterations", 2**31 - 1)
        self._native = _native.HarmonicSolver(
            mesh,
            None if vertices is None else as_painted(vertices),
            laplacian,
            method,
            precision,
            memory_budget,
            None if tolerance is None else as_real(tolerance, "tolerances"),
            max_iterations,
            as_token(cancel),
        )
        self._report: SolveReport | None = None

    def paint(self, vertices: ArrayLike, values: ArrayLike, source: ArrayLike | None = None) -> Reals:
        """A new painting and its field: (V,) for values (C,), or (V, k) for (C, k).

        Computes no more than what changed since the last one, and `report.update` says what that was. The field does
        not depend on what was painted before: bit for bit for a direct method in float64, else to the tolerance.
        Arguments, result and errors otherwise as for `solve`; after an InputError the last painting stays.
        """
        return self._solved(self._native.paint, values, source, as_painted(vertices))

    def solve(self, values: ArrayLike, source: ArrayLike | None = None) -> Reals:
        """The field for painted values (C,) or (C, k), aligned with the vertices: (V,) or (V, k).

        source  (V,) or nothing: at free vertices mass⁻¹ K φ = source (graph: (I − D⁻¹A) φ), so a positive source
                raises φ; entries at painted vertices are not read.

        φ equals the painted values bit for bit where painted, and is NaN on connected pieces without paint. Raises
        InputError (a length, a number that is not finite, one vertex with two values) or SolverError. Releases the GIL.
        """
        return self._solved(self._native.solve, values, source)

    def _solved(
        self,
        solve: Callable[..., tuple[Reals, dict[str, Any]]],
        values: ArrayLike,
        source: ArrayLike | None,
        *first: Any,
    ) -> Reals:
        columns = as_reals(values, "painted values")
        if columns.ndim not in (1, 2):
            raise InputError(f"painted values have the shape {columns.shape} in place of (C,) or (C, k)")
        forcing = None
        if source is not None:
            forcing = as_reals(source, "sources")
            require_shape(forcing, (None,), "sources")
        field, report = solve(*first, columns[:, None] if columns.ndim == 1 else columns, forcing)
        self._report = SolveReport(**report)
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
    method: str = "auto",
    precision: str = "float64",
    memory_budget: int | None = None,
    source: ArrayLike | None = None,
    tolerance: float | None = None,
    max_iterations: int | None = None,
) -> Field:
    """The field (V,) that has `values` (C,) at `vertices` (C,) and is harmonic everywhere else; see HarmonicSolver."""
    numbers = as_reals(values, "painted values")
    require_shape(numbers, (None,), "painted values")
    solver = HarmonicSolver(
        mesh,
        vertices,
        laplacian=laplacian,
        method=method,
        precision=precision,
        memory_budget=memory_budget,
        tolerance=tolerance,
        max_iterations=max_iterations,
    )
    return Field(solver.solve(numbers, source), solver.report)
