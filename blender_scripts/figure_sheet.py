# SPDX-License-Identifier: GPL-3.0-or-later
"""Rendered tiles, captions and the colour ramp on one white sheet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np
from figure_text import rasterise
from numpy.typing import NDArray

Image = NDArray[np.float32]  # (h, w, 3) or with alpha (h, w, 4), sRGB, top row first

INK = (0.16, 0.17, 0.2)
_SOFT = (0.42, 0.44, 0.48)


@dataclass(frozen=True)
class Tile:
    pixels: Image
    caption: str
    marked: tuple[float, float, float, float] | None = None  # a box: left, top, width, height in pixels
    bordered: bool = False


class Sheet:
    """White paper of a size in pixels; places are (x, y) from its upper left corner."""

    def __init__(self, width: int, height: int) -> None:
        self.pixels = np.ones((height, width, 3), np.float32)

    def paste(self, image: Image, x: float, y: float) -> None:
        """Lays an image with alpha over the sheet."""
        left, top = round(x), round(y)
        box = self.pixels[top : top + image.shape[0], left : left + image.shape[1]]
        image = image[: box.shape[0], : box.shape[1]]
        box += image[..., 3:] * (image[..., :3] - box)

    def write(self, text: str, x: float, y: float, size: float, color: Sequence[float] = INK) -> None:
        """One line centred on x, its middle at y."""
        cover = rasterise(text, size)
        inked = np.empty((*cover.shape, 4), np.float32)
        inked[..., :3], inked[..., 3] = color, cover
        self.paste(inked, x - cover.shape[1] / 2, y - 0.6 * size)

    def fill(self, x: float, y: float, width: float, height: float, color: Sequence[float]) -> None:
        self.pixels[round(y) : round(y + height), round(x) : round(x + width)] = color

    def frame(self, x: float, y: float, width: float, height: float, stroke: int, color: Sequence[float]) -> None:
        """The outline of a box."""
        for left, top, w, h in (
            (x, y, width, stroke),
            (x, y + height - stroke, width, stroke),
            (x, y, stroke, height),
            (x + width - stroke, y, stroke, height),
        ):
            self.fill(left, top, w, h, color)

    def save(self, path: Path) -> None:
        """As PNG. Raises OSError where it cannot be written."""
        path.touch()  # raises with the reason, which Blender keeps to itself
        height, width, _ = self.pixels.shape
        rgba = np.ones((height, width, 4), np.float32)
        rgba[..., :3] = self.pixels[::-1]
        image = bpy.data.images.new("Figure", width, height)
        try:
            image.pixels.foreach_set(rgba.ravel())
            image.file_format, image.filepath_raw = "PNG", str(path)
            image.save()
        except RuntimeError as error:
            raise OSError("Blender could not save the picture") from error
        finally:
            bpy.data.images.remove(image)


@dataclass(frozen=True)
class Legend:
    """The ramp under the tiles: colours (n, 3) in sRGB from low to high, and the window marked on it."""

    colors: Image
    low: float
    high: float
    window: tuple[float, float]


def compose(rows: Sequence[Sequence[Tile]], legend: Legend) -> Sheet:
    """Rows of tiles of one size, each with its caption below, and the legend under them all."""
    height, width, _ = rows[0][0].pixels.shape
    margin, gap, text = round(0.06 * width), round(0.05 * width), 0.05 * width
    line = round(2.4 * text)
    columns, stroke = len(rows[0]), max(2, round(0.003 * width))
    sheet = Sheet(
        2 * margin + columns * width + (columns - 1) * gap, 2 * margin + len(rows) * (height + line) + round(3.2 * text)
    )
    for r, row in enumerate(rows):
        for c, tile in enumerate(row):
            x, y = margin + c * (width + gap), margin + r * (height + line)
            sheet.paste(tile.pixels, x, y)
            if tile.marked:
                left, top, w, h = tile.marked
                sheet.frame(x + left, y + top, w, h, stroke, INK)
            if tile.bordered:
                sheet.frame(x, y, width, height, stroke, INK)
            sheet.write(tile.caption, x + width / 2, y + height + 0.45 * line, text)
    _draw_legend(sheet, legend, margin + len(rows) * (height + line) + 1.1 * text, text)
    return sheet


def _draw_legend(sheet: Sheet, legend: Legend, y: float, text: float) -> None:
    full = sheet.pixels.shape[1]
    width, height = round(0.4 * full), round(0.55 * text)
    x = (full - width) / 2
    places = np.linspace(0, len(legend.colors) - 1, width).round().astype(int)
    bar = np.ones((height, width, 4), np.float32)
    bar[..., :3] = legend.colors[places]
    sheet.paste(bar, x, y)
    span = legend.high - legend.low
    for value in (legend.low, legend.high):
        sheet.write(f"{value:.2f}", x + (value - legend.low) / span * width, y + height + 0.9 * text, 0.8 * text, _SOFT)
    left, right = (x + (value - legend.low) / span * width for value in legend.window)
    stroke = max(2, round(0.06 * text))
    sheet.frame(left, y - 0.3 * text, right - left, height + 0.6 * text, stroke, INK)
    for value, place in zip(legend.window, (left, right)):
        sheet.write(f"{value:.2f}", place, y + height + 0.9 * text, 0.8 * text, INK)
