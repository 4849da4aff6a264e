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


def as_array(values: ArrayLike, what: str) -> NDArray[Any]:
    """An array of any type. Raises InputError for rows of different lengths, and for what a masked array masks."""
    if isinstance(values, np.ma.MaskedArray) and values.mask.any():
        raise InputError(f"{what} are masked at {_place(np.argwhere(values.mask))}")
    try:
        return np.asarray(values)
    except ValueError:
        raise InputError(f"{what} do not form an array: they are of different lengths") from None


def _place(found: NDArray[np.intp], what: str = "number") -> str:
    """Where the first of np.argwhere is, and how many more there are."""
    if found.shape[1] == 0:
        return "its only place"
    return f"{'row' if found.shape[1] > 1 else 'place'} {found[0][0]}{and_more(len(found), what)}"


def _laid_out(array: NDArray[Any], dtype: type[Any]) -> NDArray[Any]:
    return np.require(np.ascontiguousarray(array, dtype=dtype), requirements="A")  # aligned, which the first is not


def _require_numbers(values: ArrayLike, array: NDArray[Any], what: str, kinds: str, numbers: str) -> None:
    """Refuses another type of array than of `kinds`, naming what is in it."""
    if array.dtype.kind in kinds:
        return
    got: Any = array.dtype
    if array.dtype == object:
        got = type(values).__name__ if array.ndim == 0 else "object"
        other = [place for place, entry in np.ndenumerate(array) if not isinstance(entry, (int, float, np.number))]
        if array.ndim > 0 and other:
            got = f"{array[other[0]]!r} at {_place(np.array(other), 'element')}"
    raise InputError(f"{what} have to be {numbers}, not {got}")


def as_indices(values: ArrayLike, what: str) -> Indices:
    """Whole numbers as C-ordered int32; one that 32 bits cannot hold is refused, never wrapped."""
    array = as_array(values, what)
    if array.dtype == np.int32 or array.size == 0:
        return _laid_out(array, np.int32)
    are_too_large = array.dtype == object and all(type(entry) is int for entry in array.flat)  # some, for 64 bits
    if not are_too_large:
        _require_numbers(values, array, what, "iu", "whole numbers")
    limits = np.iinfo(np.int32)
    if array.min() < limits.min or array.max() > limits.max:
        bad = np.argwhere((array < limits.min) | (array > limits.max))
        raise InputError(f"{what} have {array[tuple(bad[0])]} at {_place(bad)}, which is not an index")
    return _laid_out(array, np.int32)


def as_reals(values: ArrayLike, what: str) -> Reals:
    """Numbers as C-ordered float64."""
    array = as_array(values, what)
    if array.dtype == object and all(isinstance(entry, (int, float)) for entry in array.flat):  # some beyond 64 bits
        try:
            array = array.astype(np.float64)
        except OverflowError:
            raise InputError(f"{what} have a number beyond the largest float64") from None
    _require_numbers(values, array, what, "fiub", "real numbers")
    return _laid_out(array, np.float64)


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
