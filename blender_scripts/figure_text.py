# SPDX-License-Identifier: GPL-3.0-or-later
"""Words as pixels: Blender's own font, outlined and filled by Blender, rasterised here."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

_FINE = 4  # samples per pixel along each axis


def rasterise(text: str, size: float) -> NDArray[np.float32]:
    """Coverage (h, w) in [0, 1] of one line of text, `size` pixels high with its ascenders and descenders."""
    corners = _outline(text) * size * _FINE
    corners -= (np.floor(corners[..., 0].min() / _FINE) * _FINE, np.floor(-0.25 * size) * _FINE)
    width = int(np.ceil(corners[..., 0].max() / _FINE)) + 1
    height = int(np.ceil(size)) + 1
    fine = np.zeros((height * _FINE, width * _FINE), bool)
    for triangle in corners:
        _fill(fine, triangle)
    return fine.reshape(height, _FINE, width, _FINE).mean(axis=(1, 3), dtype=np.float32)[::-1]


def _outline(text: str) -> NDArray[np.float64]:
    """Triangles (T, 3, 2) of the text, a line of it 1 high, its baseline at 0."""
    curve = bpy.data.curves.new("Caption", "FONT")
    curve.body = text
    obj = bpy.data.objects.new("Caption", curve)
    try:
        mesh = obj.to_mesh()
        mesh.calc_loop_triangles()
        corners = [[mesh.vertices[v].co.xy for v in triangle.vertices] for triangle in mesh.loop_triangles]
        return np.array(corners, np.float64).reshape(-1, 3, 2)
    finally:
        bpy.data.objects.remove(obj)
        bpy.data.curves.remove(curve)


def _fill(image: NDArray[np.bool_], triangle: NDArray[np.float64]) -> None:
    """Sets the pixels (row = y, column = x) whose centres are in the triangle."""
    low = np.maximum(np.floor(triangle.min(axis=0)).astype(int), 0)
    high = np.ceil(triangle.max(axis=0)).astype(int) + 1
    box = image[low[1] : high[1], low[0] : high[0]]
    y, x = np.mgrid[low[1] : low[1] + box.shape[0], low[0] : low[0] + box.shape[1]] + 0.5
    ahead = np.roll(triangle, -1, axis=0) - triangle
    sides = [ax * (y - py) - ay * (x - px) for (px, py), (ax, ay) in zip(triangle, ahead)]
    box |= np.all(np.greater_equal(sides, 0), axis=0) | np.all(np.less_equal(sides, 0), axis=0)
