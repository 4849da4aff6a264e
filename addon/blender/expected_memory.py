# SPDX-License-Identifier: GPL-3.0-or-later
"""What a large mesh will ask of the machine, for people to agree to first.

Bytes held at most, beside Blender's own, measured on closed triangle meshes: connectivity takes 160 a vertex, multigrid
420; a factorisation with all that makes strokes quick takes 1260 at 125,000 vertices, 1390 at a million and 1560 at
four: by nested dissection it grows with n log n, here 70 n log2 n.
"""

from __future__ import annotations

from math import log2

_CONNECTIVITY, _ITERATIVE, _FACTOR = 160, 420, 70
_STORED = 20  # for a number of the factor, with what makes strokes quick


def of_lines(vertices: int) -> float:
    return _CONNECTIVITY * vertices


def of_solver(vertices: int, factor_nonzeros: int) -> float:
    """What a solver holds beside the connectivity, given the numbers that its factor has stored; none: multigrid."""
    return _STORED * factor_nonzeros if factor_nonzeros else (_ITERATIVE - _CONNECTIVITY) * vertices


def of_field(vertices: int, method: str, memory_budget: int | None) -> float:
    """method: of Object.dirichlet; memory_budget: bytes that the automatic one keeps to, None for any."""
    iterative, direct = _ITERATIVE * vertices, _FACTOR * vertices * log2(max(vertices, 2))
    if method in ("multigrid", "lscg"):
        return iterative
    return min(direct, max(memory_budget, iterative)) if method == "auto" and memory_budget else direct
