# SPDX-License-Identifier: GPL-3.0-or-later
"""The word NAME=VALUE@PLACE of the command line: a patch, painted from a file of vertices or as a ball."""

from __future__ import annotations

import argparse
import math
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._native import InputError
from .painting import Patch

_NOT_AN_INDEX = re.compile(r"[^\s,]*[^\s,\d][^\s,]*|\d{19,}", re.ASCII)


@dataclass(frozen=True)
class PatchArgument:
    """A patch as it was asked for; place: a file of vertices, or (x, y, z, r) for the vertices within r of a point."""

    name: str
    value: float
    place: Path | tuple[float, ...]

    def to_patch(self, positions: NDArray[np.float64]) -> Patch:
        """The patch on a mesh with these positions (V, 3). Raises InputError for a file that cannot be read."""
        if isinstance(self.place, Path):
            return Patch(self.name, read_vertices(self.place), self.value)
        x, y, z = (positions - self.place[:3]).T
        inside = np.hypot(np.hypot(x, y), z) <= self.place[3]  # exact and without overflow, unlike a sum of squares
        return Patch(self.name, np.flatnonzero(inside), self.value)


def parse_patch(text: str) -> PatchArgument:
    """NAME=VALUE@FILE-OF-IDS or NAME=VALUE@x,y,z,r. Raises argparse.ArgumentTypeError, one sentence."""
    name, equals, rest = text.partition("=")
    value_text, at, place = rest.partition("@")
    if not (name and equals and at and place):
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME=VALUE@FILE-OF-IDS or NAME=VALUE@x,y,z,r")
    try:
        value = float(value_text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"the value '{value_text}' of patch '{name}' is not a number") from None
    try:
        ball = parse_numbers(place)
    except argparse.ArgumentTypeError:
        return PatchArgument(name, value, Path(place))
    if len(ball) != 4 or ball[3] < 0:
        raise argparse.ArgumentTypeError(f"'{place}' of patch '{name}' is not x,y,z,r with r of 0 or more")
    return PatchArgument(name, value, ball)


def parse_numbers(text: str) -> tuple[float, ...]:
    """Finite numbers with commas in between. Raises argparse.ArgumentTypeError, one sentence."""
    try:
        numbers = tuple(float(word) for word in text.split(","))
    except ValueError:
        numbers = (math.nan,)
    if not all(map(math.isfinite, numbers)):
        raise argparse.ArgumentTypeError(f"'{text}' is not a list of finite numbers with commas in between")
    return numbers


def read_vertices(path: Path) -> NDArray[np.integer[Any]]:
    """Vertex indices from 0, separated by blanks, commas or line ends. Raises InputError with file, line and word."""
    try:
        text = path.read_text(encoding="utf-8-sig", errors="replace")
    except OSError as error:
        raise InputError(f"cannot read the vertices of a patch from '{path}': {error.strerror}") from error
    bad = _NOT_AN_INDEX.search(text)
    if bad:
        line = 1 + text.count("\n", 0, bad.start())
        raise InputError(f"'{path}', line {line}: '{bad.group():.40}' is not the index of a vertex")
    return np.array(text.replace(",", " ").split(), dtype=np.int64)
