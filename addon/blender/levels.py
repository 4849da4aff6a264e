# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels of the isolines, from an object's settings."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from .. import library


def choose_levels(settings: bpy.types.PropertyGroup, low: float, high: float) -> NDArray[np.float64]:
    """Ascending or as listed; `low` and `high` are the field's range, the window unless the user set another.

    Raises InputError as the library's level helpers do, and for a list that is not of numbers.
    """
    surface = library.load()
    if settings.levels_mode == "LIST":
        return parse_levels(settings.levels_list)
    if not settings.window_auto:
        low, high = settings.window_low, settings.window_high
    if settings.levels_mode == "STEP":
        return surface.stepped_levels(low, high, settings.step, settings.phase)
    return surface.even_levels(low, high, settings.count)


def parse_levels(text: str) -> NDArray[np.float64]:
    """Numbers between commas, semicolons or spaces."""
    words = text.replace(",", " ").replace(";", " ").split()
    if not words:
        raise library.load().InputError("the list of levels is empty: write numbers, such as 0.1, 0.25, 0.5")
    levels = []
    for place, word in enumerate(words, start=1):
        try:
            levels.append(float(word))
        except ValueError:
            raise library.load().InputError(f"level {place} of the list, '{word}', is not a number") from None
    return np.array(levels)
