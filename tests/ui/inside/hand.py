# SPDX-License-Identifier: GPL-3.0-or-later
"""A user's hand: real events, by xdotool, at pixels counted from the screen's upper left corner."""

from collections.abc import Iterable

from steps import Waiting, finished

Pixel = tuple[int, int]
_PAUSE = ("sleep", 0.15)  # Blender sees what is under the pointer when it has drawn


def move(pixel: Pixel) -> Waiting:
    yield from finished("xdotool", "mousemove", *pixel)
    yield 0.05


def click(pixel: Pixel, button: int = 1, times: int = 1) -> Waiting:
    yield from finished("xdotool", "mousemove", *pixel, *_PAUSE, "click", "--repeat", times, button)
    yield 0.4


def press(keys: str) -> Waiting:
    """keys: as xdotool names them, such as ctrl+z."""
    yield from finished("xdotool", "key", keys)
    yield 0.6


def drag(path: Iterable[Pixel], pause: float = 0.05) -> Waiting:
    """Along the pixels with the left button down, so many seconds at each: a stroke, or a slider's way."""
    first, *rest = path
    way = [word for pixel in rest for word in ("mousemove", *pixel, "sleep", pause)]
    yield from finished("xdotool", "mousemove", *first, *_PAUSE, "mousedown", 1, *_PAUSE, *way, *_PAUSE, "mouseup", 1)
    yield 0.4


def line(start: Pixel, end: Pixel, pieces: int = 8) -> list[Pixel]:
    """Pixels evenly from start to end."""
    return [tuple(round(a + (b - a) * k / pieces) for a, b in zip(start, end)) for k in range(pieces + 1)]
