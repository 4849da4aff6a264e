# SPDX-License-Identifier: GPL-3.0-or-later
"""Painted patches, and what they say together: one value for every painted vertex."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from .errors import InputError

OverlapRule = Literal["error", "first", "highest", "average"]
OVERLAP_RULES: tuple[OverlapRule, ...] = get_args(OverlapRule)


@dataclass(frozen=True)
class Patch:
    """Vertices painted under one name.

    vertices: (c,) integers in [0, V), any order; one named repeatedly counts once.
    values:   one number for the whole patch, or (c,) one per vertex; finite.
    """

    name: str
    vertices: NDArray[np.integer[Any]]
    values: float | NDArray[np.float64]


@dataclass(frozen=True)
class Painting:
    """What `solve` takes: vertices (C,) int32, ascending and unique; values (C,) float64. Warnings: one sentence each."""

    vertices: NDArray[np.int32]
    values: NDArray[np.float64]
    warnings: tuple[str, ...] = ()


def combine_patches(patches: Sequence[Patch], vertex_count: int, overlap: OverlapRule = "error") -> Painting:
    """Merges patches into one painting.

    overlap: what a vertex in several patches with different values gets: nothing ("error"), the value of the first of
        these patches, the highest, or the average, each patch counted once.

    An empty patch among others is a warning. Raises InputError when nothing is painted at all, for a vertex outside the
    mesh, a value that is not finite, a vertex that one patch gives two values, and for overlaps as the rule says.
    Cost: O(C log C).
    """
    if overlap not in OVERLAP_RULES:
        raise InputError(f"the overlap rule '{overlap}' is unknown: it is one of {', '.join(OVERLAP_RULES)}")
    if not patches:
        raise InputError("nothing is painted: at least one patch is needed")
    arrays = [_patch_arrays(patch, vertex_count) for patch in patches]
    empty = [patch.name for patch, (vertices, _) in zip(patches, arrays) if not vertices.size]
    if len(empty) == len(patches):
        raise InputError(f"nothing is painted: {_quote(empty)} without vertices")

    vertices = np.concatenate([vertices for vertices, _ in arrays])
    values = np.concatenate([values for _, values in arrays])
    owners = np.repeat(np.arange(len(patches)), [vertices.size for vertices, _ in arrays])
    order = np.lexsort((owners, vertices))
    vertices, values = _merge(patches, vertices[order], values[order], owners[order], overlap)
    warnings = (f"{_quote(empty)} without vertices and left out",) if empty else ()
    return Painting(vertices.astype(np.int32), values, warnings)


def _patch_arrays(patch: Patch, vertex_count: int) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    vertices = np.asarray(patch.vertices)
    if vertices.ndim != 1 or (vertices.size and vertices.dtype.kind not in "iu"):
        raise InputError(
            f"patch '{patch.name}': vertices have to be a list of integers, not {vertices.dtype} of shape {vertices.shape}"
        )
    outside = np.flatnonzero((vertices < 0) | (vertices >= vertex_count))
    if outside.size:
        raise InputError(
            f"patch '{patch.name}': vertex {vertices[outside[0]]} is not in the mesh, "
            f"whose vertices are 0 … {vertex_count - 1}{_more(outside.size)}"
        )
    try:
        values = np.asarray(patch.values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"patch '{patch.name}': its value has to be a number, not {patch.values!r:.40}") from None
    if values.ndim and values.shape != vertices.shape:
        raise InputError(f"patch '{patch.name}': {vertices.size} vertices do not go with values of shape {values.shape}")
    values = np.broadcast_to(values, vertices.shape)
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        raise InputError(
            f"patch '{patch.name}': the value {values[bad[0]]} of vertex {vertices[bad[0]]} is not finite{_more(bad.size)}"
        )
    return vertices.astype(np.int64), values


def _merge(
    patches: Sequence[Patch],
    vertices: NDArray[np.int64],
    values: NDArray[np.float64],
    owners: NDArray[np.intp],
    overlap: OverlapRule,
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """One value per vertex; the arrays come sorted by vertex, then by patch."""
    repeated = (vertices[1:] == vertices[:-1]) & (owners[1:] == owners[:-1])
    _refuse_two_values(patches, vertices, owners, values, 1 + np.flatnonzero(repeated & (values[1:] != values[:-1])))
    once = np.concatenate(([True], ~repeated))
    vertices, values, owners = vertices[once], values[once], owners[once]

    starts = np.concatenate(([True], vertices[1:] != vertices[:-1]))
    first = np.flatnonzero(starts)
    group = np.cumsum(starts) - 1
    if overlap == "error":
        _refuse_two_values(patches, vertices, owners, values, np.flatnonzero(values != values[first][group]), first[group])
    if overlap == "highest":
        return vertices[first], np.maximum.reduceat(values, first)
    if overlap == "average":
        share = values / np.diff(first, append=len(values))[group]  # differences of shares: equal values stay exact,
        return vertices[first], values[first] + np.add.reduceat(share - share[first][group], first)  # huge ones finite
    return vertices[first], values[first]


def _refuse_two_values(
    patches: Sequence[Patch],
    vertices: NDArray[np.int64],
    owners: NDArray[np.intp],
    values: NDArray[np.float64],
    clashes: NDArray[np.intp],
    others: NDArray[np.intp] | None = None,
) -> None:
    """Raises for the first entry of `clashes`, which disagrees with the entry others[clash], or with the one before."""
    if not clashes.size:
        return
    this = clashes[0]
    other = this - 1 if others is None else others[this]
    raise InputError(
        f"vertex {vertices[this]} is in '{patches[owners[other]].name}' with value {values[other]:g} "
        f"and in '{patches[owners[this]].name}' with value {values[this]:g}{_more(np.unique(vertices[clashes]).size)}"
    )


def _more(count: int) -> str:
    """What a message about the first of `count` vertices adds."""
    return "" if count == 1 else f" (and {count - 1} more {'vertex' if count == 2 else 'vertices'})"


def _quote(names: Sequence[str]) -> str:
    """The subject of a sentence: at most three names, then how many more."""
    shown = ", ".join(f"'{name}'" for name in names[:3])
    rest = f" and {len(names) - 3} more" if len(names) > 3 else ""
    return f"patch {shown} is" if len(names) == 1 else f"patches {shown}{rest} are"
