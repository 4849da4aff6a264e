# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers in sentences."""

from __future__ import annotations

import numpy as np


def counted(count: int, noun: str) -> str:
    """1 level, 2 levels"""
    return f"{count} {_number_of(count, noun)}"


def and_more(count: int, noun: str) -> str:
    """What a sentence about the first of `count` adds: nothing, or how many more there are."""
    return "" if count <= 1 else f" (and {count - 1} more {_number_of(count - 1, noun)})"


def exactly(value: float) -> str:
    """The fewest digits that tell a number from its neighbours; of a single-precision one, as hosts keep it, from its
    neighbours there: 0.1, not 0.10000000149011612."""
    with np.errstate(over="ignore"):
        short = np.float32(value)
    return str(short if short == value else float(value)).removesuffix(".0")


def told_apart(*values: float) -> list[str]:
    """Six digits of each, or as many as it takes where different numbers would look the same."""
    texts = [f"{value:.6g}" for value in values]
    return texts if len(set(texts)) == len(set(values)) else [exactly(value) for value in values]


def _number_of(count: int, noun: str) -> str:
    if count == 1:
        return noun
    return noun.removesuffix("ex") + "ices" if noun.endswith("vertex") else noun + "s"
