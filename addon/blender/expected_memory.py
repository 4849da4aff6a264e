# SPDX-License-Identifier: GPL-3.0-or-later
"""What a large mesh will ask of the machine, for people to agree to first.

Bytes held at most, beside Blender's own, measured on closed triangle meshes: connectivity takes 160 a vertex, multigrid
420; a factorisation with all that makes strokes quick takes 1260 at 125,000 vertices, 1390 at a million and 1560 at
four: by nested dissection it grows with n log n, here 70 n log2 n. A Laplacian that couples all corners of a face takes
as much for quads, and half more for hexagons: 1814 at 125,000 vertices.
"""

from __future__ import annotations

from math import log2

import bpy

_CONNECTIVITY, _ITERATIVE, _FACTOR = 160, 420, 70
_STORED = 20  # for a number of the factor, with what makes strokes quick


def of_lines(vertices: int) -> float:
    return _CONNECTIVITY * vertices


def of_solver(vertices: int, factor_nonzeros: int) -> float:
    """What a solver holds beside the connectivity, given the numbers that its factor has stored; none: multigrid."""
    return _STORED * factor_nonzeros if factor_nonzeros else (_ITERATIVE - _CONNECTIVITY) * vertices


def of_field(vertices: int, method: str, memory_budget: int | None, coupled: float = 3.0) -> float:
    """method: of Object.dirichlet; memory_budget: bytes that the automatic one keeps to, None for any; coupled: corners
    of an average face, where the Laplacian couples all of them."""
    iterative = _ITERATIVE * vertices
    direct = _FACTOR * max(coupled / 4, 1.0) * vertices * log2(max(vertices, 2))
    if method in ("multigrid", "lscg"):
        return iterative
    return min(direct, max(memory_budget, iterative)) if method == "auto" and memory_budget else direct


def of_object(obj: bpy.types.Object, memory_budget: int | None) -> float:
    """As `of_field`, for the mesh and the settings of an object."""
    mesh, settings = obj.data, obj.dirichlet
    couples = settings.laplacian in ("polygon", "auto")  # the automatic one may take polygon
    coupled = len(mesh.loops) / max(len(mesh.polygons), 1) if couples else 3.0
    return of_field(len(mesh.vertices), settings.method, memory_budget, coupled)
