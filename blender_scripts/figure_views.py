# SPDX-License-Identifier: GPL-3.0-or-later
"""Where to look from, and what to look at: plain geometry on arrays, no Blender."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_CELLS = 96  # of the coarse grid that stands for a picture, along its longer side
UPRIGHT = {  # rotations that make an axis of a file point up, z here
    "x": ((0, 1, 0), (0, 0, 1), (1, 0, 0)),
    "y": ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    "z": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
}
_AZIMUTHS = range(0, 360, 15)


@dataclass(frozen=True)
class View:
    """A direction in degrees: azimuth 0 looks along +y, 90 along -x; the elevation is above the horizon."""

    azimuth: float
    elevation: float = 8.0

    def towards_viewer(self) -> Array:
        azimuth, elevation = np.radians((self.azimuth, self.elevation))
        flat = np.cos(elevation)
        return np.array([np.sin(azimuth) * flat, -np.cos(azimuth) * flat, np.sin(elevation)])

    def frame(self) -> Array:
        """Rows: right, up, towards the viewer."""
        back = self.towards_viewer()
        right = np.cross((0.0, 0.0, 1.0), back)
        right /= np.linalg.norm(right)
        return np.array([right, np.cross(back, right), back])


def best_view(points: Array, painted: NDArray[np.integer]) -> View:
    """The direction that shows a broad outline and many painted ones among the points (P, 3) of a surface."""
    scores = []
    for azimuth in _AZIMUTHS:
        seen = points @ View(azimuth).frame().T
        grid = (seen[:, :2] - seen[:, :2].min(axis=0)) / np.ptp(points, axis=0).max() * _CELLS
        shown = visible(grid, -seen[:, 2], 0.03 * np.ptp(seen[:, 2]))
        outline = len(np.unique(grid.astype(int) @ (1, 4 * _CELLS)))
        scores.append(outline * (1 + shown[painted].mean()))
    return View(_AZIMUTHS[int(np.argmax(scores))])


def other_side(view: View) -> View:
    return replace(view, azimuth=(view.azimuth + 180) % 360)


def visible(cells: Array, depth: Array, tolerance: float) -> NDArray[np.bool_]:
    """(P,) whether a point is among the nearest of its unit cell; cells (P, 2), depth (P,) away from the viewer."""
    _, owner = np.unique(np.floor(cells).astype(int), axis=0, return_inverse=True)
    owner = owner.ravel()  # NumPy 2.0 keeps the axis
    nearest = np.full(owner.max() + 1, np.inf)
    np.minimum.at(nearest, owner, depth)
    return depth <= nearest[owner] + tolerance


def busiest_spot(places: Array, zoom: float) -> tuple[float, float]:
    """The centre of the frame, 1/zoom of the picture wide and high, with places (P, 2) in [0, 1]² in
    most of its cells: many lines, but not one thick bundle. The middle of the picture without any place."""
    if not len(places):
        return 0.5, 0.5
    counts, _, _ = np.histogram2d(*places.T, bins=_CELLS, range=((0, 1), (0, 1)))
    size = max(1, round(_CELLS / zoom))
    total = np.pad((counts > 0).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    inside = total[size:, size:] - total[:-size, size:] - total[size:, :-size] + total[:-size, :-size]
    column, row = np.unravel_index(int(np.argmax(inside)), inside.shape)
    corner = np.array((column, row)) / _CELLS
    framed = places[((places >= corner) & (places <= corner + size / _CELLS)).all(axis=1)]
    x, y = np.clip(framed.mean(axis=0), 0.5 / zoom, 1 - 0.5 / zoom)
    return float(x), float(y)
