# SPDX-License-Identifier: GPL-3.0-or-later
"""Painted patches, and what they say together: one value for every painted vertex."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray

from ._arrays import as_indices, as_reals, require_shape
from ._native import InputError
from ._text import and_more, exactly

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
    """What `solve` takes: vertices (C,) int32, ascending, unique; values (C,) float64; warnings, one sentence each."""

    vertices: NDArray[np.int32]
    values: NDArray[np.float64]
    warnings: tuple[str, ...] = ()


def combine_patches(patches: Sequence[Patch], vertex_count: int, overlap: OverlapRule = "error") -> Painting:
    """Merges patches into one painting.

    overlap: what a vertex in several patches with different values gets: nothing ("error"), the value of the first of
        these patches, the highest, or the average.

    An empty patch among others is a warning. Raises InputError when nothing is painted at all, for a vertex outside the
    mesh, a value that is not finite, a vertex that one patch gives two values, and for overlaps as the rule says.
    Cost: O(C log C).
    """
    if overlap not in OVERLAP_RULES:
        raise InputError(f"the overlap rule '{overlap}' is unknown: it is one of {', '.join(OVERLAP_RULES)}")
    if not patches:
        raise InputError("nothing is painted: at least one patch is needed")
    arrays = [_checked_arrays(patch, vertex_count) for patch in patches]
    empty = [patch.name for patch, (vertices, _) in zip(patches, arrays) if not vertices.size]
    if len(empty) == len(patches):
        raise InputError(f"nothing is painted: {_no_vertices(empty)}")

    vertices, values = (np.concatenate(column) for column in zip(*arrays))
    owners = np.repeat(np.arange(len(patches)), [vertices.size for vertices, _ in arrays])
    order = np.lexsort((owners, vertices))
    vertices, values = _merge(_Entries(vertices, values, owners).at(order), [patch.name for patch in patches], overlap)
    warnings = (f"{_no_vertices(empty)}: left out",) if empty else ()
    return Painting(vertices, values, warnings)


class _Entries(NamedTuple):
    """Who paints what: vertex, value and the patch's place in the list."""

    vertices: NDArray[np.int32]
    values: NDArray[np.float64]
    owners: NDArray[np.intp]

    def at(self, places: NDArray[Any]) -> _Entries:
        return _Entries(*(column[places] for column in self))


def _checked_arrays(patch: Patch, vertex_count: int) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Its vertices and as many values."""
    vertices = as_indices(patch.vertices, f"the vertices of patch '{patch.name}'")
    require_shape(vertices, (None,), f"the vertices of patch '{patch.name}'")
    outside = np.flatnonzero((vertices < 0) | (vertices >= vertex_count))
    if outside.size:
        raise InputError(
            f"patch '{patch.name}' has the vertex {vertices[outside[0]]}, "
            f"but the vertices are 0 to {vertex_count - 1}{and_more(outside.size, 'vertex')}"
        )
    values = as_reals(patch.values, f"the values of patch '{patch.name}'")
    if np.ndim(patch.values) > 0:
        require_shape(values, vertices.shape, f"the values of patch '{patch.name}'")
    values = np.broadcast_to(values, vertices.shape)
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        raise InputError(
            f"patch '{patch.name}' has the value {values[bad[0]]} at vertex {vertices[bad[0]]}, "
            f"which is not finite{and_more(bad.size, 'vertex')}"
        )
    return vertices, values


def _merge(
    entries: _Entries, names: Sequence[str], overlap: OverlapRule
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Vertices and one value for each, from entries sorted by vertex, then by patch."""
    repeated = 1 + np.flatnonzero((np.diff(entries.vertices) == 0) & (np.diff(entries.owners) == 0))
    _refuse_two_values(entries, names, repeated, repeated - 1)
    entries = entries.at(np.delete(np.arange(len(entries.values)), repeated))

    vertices, first, count = np.unique(entries.vertices, return_index=True, return_counts=True)
    values = entries.values[first]
    if overlap == "error":
        way_out = f"; an overlap rule decides: {', '.join(OVERLAP_RULES[1:])}"
        _refuse_two_values(entries, names, np.arange(len(entries.values)), np.repeat(first, count), way_out)
    elif overlap == "highest":
        values = np.maximum.reduceat(entries.values, first)
    elif overlap == "average":  # through differences of shares, so that equal values stay exact and huge ones finite
        share = entries.values / np.repeat(count, count)
        values = values + np.add.reduceat(share - np.repeat(share[first], count), first)
    return vertices, values


def _refuse_two_values(
    entries: _Entries, names: Sequence[str], places: NDArray[np.intp], others: NDArray[np.intp], way_out: str = ""
) -> None:
    """Raises when the entry at one of `places` disagrees with the one at the same place of `others`, its vertex's."""
    clashes = np.flatnonzero(entries.values[places] != entries.values[others])
    if not clashes.size:
        return
    place, other = places[clashes[0]], others[clashes[0]]
    raise InputError(
        f"vertex {entries.vertices[place]} is in {_with_value(entries, names, other)} and in "
        f"{_with_value(entries, names, place)}"
        f"{and_more(np.unique(entries.vertices[places[clashes]]).size, 'vertex')}{way_out}"
    )


def _with_value(entries: _Entries, names: Sequence[str], place: int) -> str:
    return f"'{names[entries.owners[place]]}' with value {exactly(entries.values[place])}"


def _no_vertices(names: Sequence[str]) -> str:
    """A clause about at most three names, then how many more."""
    shown = ", ".join(f"'{name}'" for name in names[:3])
    rest = f" and {len(names) - 3} more" if len(names) > 3 else ""
    return f"patch {shown} has no vertices" if len(names) == 1 else f"patches {shown}{rest} have no vertices"
