# SPDX-License-Identifier: GPL-3.0-or-later
"""What callers pass, as the exact arrays the compiled module takes; no copy where type and layout already fit."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._native import InputError
from ._text import and_more

Indices = NDArray[np.int32]
Reals = NDArray[np.float64]


def _as_array(values: ArrayLike, what: str) -> NDArray[Any]:
    try:
        return np.asarray(values)
    except ValueError:
        raise InputError(f"{what} do not form an array: they are of different lengths") from None


def _kind(values: ArrayLike, array: NDArray[Any]) -> str:
    """What a caller passed in place of numbers."""
    return type(values).__name__ if array.ndim == 0 and array.dtype == object else str(array.dtype)


def as_indices(values: ArrayLike, what: str) -> Indices:
    """Whole numbers as C-ordered int32; one that 32 bits cannot hold is refused, never wrapped."""
    array = _as_array(values, what)
    if array.dtype == np.int32:
        return np.ascontiguousarray(array)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise InputError(f"{what} have to be whole numbers, not {_kind(values, array)}")
    limits = np.iinfo(np.int32)
    if array.size > 0 and (array.min() < limits.min or array.max() > limits.max):
        bad = np.argwhere((array < limits.min) | (array > limits.max))
        place = f"row {bad[0][0]}" if array.ndim > 1 else f"place {bad[0][0]}"
        number = array[tuple(bad[0])]
        raise InputError(f"{what} have {number} at {place}, which is not an index{and_more(len(bad), 'number')}")
    return np.ascontiguousarray(array, dtype=np.int32)


def as_reals(values: ArrayLike, what: str) -> Reals:
    """Numbers as C-ordered float64."""
    array = _as_array(values, what)
    if array.dtype.kind not in "fiub":
        raise InputError(f"{what} have to be real numbers, not {_kind(values, array)}")
    return np.ascontiguousarray(array, dtype=np.float64)


def as_real(value: Any, what: str) -> float:
    """One number; `what` in the plural."""
    number = as_reals([value], what)
    require_shape(number, (1,), what)
    return float(number[0])


def as_count(value: Any, what: str, most: int) -> int:
    """A whole number from 1 to `most`."""
    try:
        count = operator.index(value)
    except TypeError:
        raise InputError(f"{what} has to be a whole number, not {value!r}") from None
    if not 1 <= count <= most:
        raise InputError(f"{what} is {count}, but has to be from 1 to {most}")
    return count


def as_painted(vertices: ArrayLike) -> Indices:
    """Painted vertices (C,)."""
    painted = as_indices(vertices, "painted vertices")
    require_shape(painted, (None,), "painted vertices")
    return painted


def require_name(name: Any, names: Iterable[str], what: str) -> None:
    """Refuses what is not one of them."""
    if name not in tuple(names):
        raise InputError(f"there is no {what} {name!r}; choose from: {', '.join(names)}")


def require_shape(array: NDArray[Any], shape: tuple[int | None, ...], what: str) -> None:
    """Refuses another shape; None stands for any size."""
    fits = array.ndim == len(shape) and all(want in (None, got) for want, got in zip(shape, array.shape, strict=True))
    if not fits:
        wanted = ", ".join("any" if size is None else str(size) for size in shape)
        raise InputError(f"{what} have the shape {array.shape} in place of ({wanted}{',' * (len(shape) == 1)})")
