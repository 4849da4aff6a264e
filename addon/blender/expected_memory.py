# SPDX-License-Identifier: GPL-3.0-or-later
"""What a large mesh will ask of the machine, for people to agree to first.

Bytes held at most, beside Blender's own, measured on closed triangle meshes: connectivity takes 160 a vertex, multigrid
420; a factorisation with all that makes strokes quick takes 1260 at 125,000 vertices, 1390 at a million and 1560 at
four: by nested dissection it grows with n log n, here 70 n log2 n.
"""

from __future__ import annotations

from math import log2

_CONNECTIVITY, _ITERATIVE, _FACTOR = 160, 420, 70


def of_lines(vertices: int) -> float:
    return _CONNECTIVITY * vertices


def of_field(vertices: int, method: str, budget: int | None) -> float:
    """method: of Object.dirichlet; budget: bytes that the automatic one keeps to, nothing for as many as it likes."""
    iterative, direct = _ITERATIVE * vertices, _FACTOR * vertices * log2(max(vertices, 2))
    if method in ("multigrid", "lscg"):
        return iterative
    return min(direct, max(budget, iterative)) if method == "auto" and budget else direct
