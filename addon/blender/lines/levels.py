# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of the isolines, from an object's settings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say

_SPREADS = {"EQUAL_AREA": "equal_area_levels", "EQUAL_DISTANCE": "equal_distance_levels"}


@dataclass(frozen=True)
class LevelOptions:
    """How levels are chosen, as LineSettings has it."""

    mode: str
    count: int
    step: float
    phase: float
    listed: str
    window: tuple[float, float] | None  # None: the field's range

    def window_in(self, low: float, high: float) -> tuple[float, float]:
        """The window of values in a field that ranges from `low` to `high`."""
        return self.window or (low, high)

    def choose_on(self, mesh, values: NDArray[np.floating], cancel: Any) -> NDArray[np.float64]:
        """Ascending or as listed; mesh: the library's, values: (V,) of the field, not all NaN, cancel: the library's
        CancelToken. Raises what `choose` and the library's ways to spread levels over a surface raise."""
        low, high = float(np.fmin.reduce(values)), float(np.fmax.reduce(values))
        if low == high and self.mode != "LIST":
            raise library.load().InputError(
                say("the field is {value} everywhere: give another patch another value", value=f"{low:.6g}")
            )
        if self.mode not in _SPREADS:
            return self.choose(low, high)
        spread = getattr(library.load(), _SPREADS[self.mode])
        return spread(mesh, values, self.count, *self.window_in(low, high), cancel=cancel)

    def choose(self, low: float, high: float) -> NDArray[np.float64]:
        """Ascending or as listed; `low` and `high` are the field's range, the window unless the user set another.

        Raises InputError as the library's level helpers do, for a list that is not of numbers, and for levels that
        depend on the surface, too.
        """
        surface = library.load()
        if self.mode in _SPREADS:
            raise surface.InputError(say("levels at equal areas or distances depend on more than the field's range"))
        if self.mode == "LIST":
            return parse_levels(self.listed)
        low, high = self.window_in(low, high)
        if self.mode == "STEP":
            return surface.stepped_levels(low, high, self.step, self.phase)
        return surface.even_levels(low, high, self.count)


def read_options(settings: bpy.types.PropertyGroup) -> LevelOptions:
    """settings: a LineSettings, whose window has no say in levels that are listed."""
    low, high, step, phase = (
        float(written(getattr(settings, name))) for name in ("window_low", "window_high", "step", "phase")
    )
    window = None if settings.window_auto or settings.levels_mode == "LIST" else (low, high)
    return LevelOptions(settings.levels_mode, settings.count, step, phase, settings.levels_list, window)


def written(number: float) -> str:
    """What Blender keeps in float32 as people write it: 0.1 would come back as 0.10000000149. With as many digits as
    tell such numbers apart."""
    return str(np.float32(number))


def parse_levels(text: str) -> NDArray[np.float64]:
    """Numbers between commas, semicolons or spaces."""
    words = text.replace(",", " ").replace(";", " ").split()
    if not words:
        raise library.load().InputError(say("the list of levels is empty: write numbers, such as 0.1, 0.25, 0.5"))
    levels = []
    for place, word in enumerate(words, start=1):
        try:
            levels.append(float(word))
        except ValueError:
            raise library.load().InputError(
                say("level {place} of the list, '{word}', is not a number", place=place, word=word)
            ) from None
    return np.array(levels)
