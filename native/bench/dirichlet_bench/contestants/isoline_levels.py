# SPDX-License-Identifier: GPL-3.0-or-later
"""The isolines that are asked of every library."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..recorder import Recorder

Reals = NDArray[np.float64]
COUNTS = (13, 100)


def time_levels(
    recorder: Recorder, extract: Callable[[Reals], Callable[[], float]], counts: tuple[int, ...] = COUNTS
) -> None:
    """`extract` makes the lines of those levels; what it returns sums up their lengths, which all have to agree on."""
    for count in counts:
        levels = (np.arange(count) + 0.5) / count

        def once(_: int, count: int = count, levels: Reals = levels) -> None:
            with recorder.time(f"{count} isolines"):
                measure = extract(levels)
            recorder.state(f"length of {count}", measure())

        recorder.repeat(once)


def segment_length(points: Reals, segments: NDArray[np.integer]) -> float:
    return float(np.linalg.norm(points[segments[:, 0]] - points[segments[:, 1]], axis=1).sum())
