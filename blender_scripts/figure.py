# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's Figures 1 and 4 of an object that the add-on has painted patches and a field on.

Above: painted patches | field | isolines. Below, from another side: field | isolines in a window | a close-up.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType

import bpy
import figure_materials
import numpy as np
from addon_loader import part
from figure_scene import Studio
from figure_sheet import Legend, Sheet, Tile, compose
from figure_views import View, busiest_spot, visible

_LINE = 0.005  # width of a line, as a fraction of the picture's height
_CELLS = 48  # of the grid that tells what hides what, along each side of the picture


@dataclass(frozen=True)
class Plan:
    """What the figure shows, and how large."""

    above: View
    below: View
    window: tuple[float, float]  # of values, for the second row
    levels: int = 13  # of each set of isolines
    zoom: float = 3.0  # of the close-up
    spot: tuple[float, float] | None = None  # its middle in the picture; nothing: where most lines are
    width: int = 800  # of one tile, in pixels
    height: int = 700


def make_figure(addon: ModuleType, obj: bpy.types.Object, plan: Plan) -> Sheet:
    """Renders the six tiles. Leaves the object with `plan.levels` isolines, spread over the whole range."""
    with Studio(addon, obj, plan.width, plan.height) as studio:
        colored = figure_materials.colored(addon, obj)
        mask = np.zeros(len(obj.data.vertices), bool)
        mask[part(addon, "blender.paint.painting").read_painting(obj).vertices] = True
        studio.look(plan.below)
        below = [_tile(studio, colored, "field, from another side"), *_windowed(addon, obj, studio, plan)]
        studio.look(plan.above)
        lines = _isolines(addon, obj, plan.levels)
        above = [
            _tile(studio, figure_materials.painted(addon, studio.mesh, mask), "painted patches"),
            _tile(studio, colored, "harmonic field"),
            _tile(studio, colored, f"isolines at {plan.levels} levels", lines),
        ]
    return compose([above, below], _legend(addon, obj, plan.window))


def _windowed(addon: ModuleType, obj: bpy.types.Object, studio: Studio, plan: Plan) -> list[Tile]:
    """Isolines in the window, the field bleached outside; and a part of that, marked, from nearer."""
    material = figure_materials.colored(addon, obj)
    studio.dress(material)
    low, high = _limits(addon, obj)
    places = (np.array(plan.window) - low) / (high - low)
    ramp = part(addon, "blender.look.material").find_ramp(studio.surface).color_ramp
    figure_materials.fade_outside(addon, ramp, *places.tolist())
    lines = _isolines(addon, obj, plan.levels, plan.window)
    spot = plan.spot or _busiest(studio, lines, plan.zoom)
    width, height = plan.width / plan.zoom, plan.height / plan.zoom
    box = spot[0] * plan.width - width / 2, (1 - spot[1]) * plan.height - height / 2, width, height
    caption = f"{plan.levels} levels from {plan.window[0]:.3g} to {plan.window[1]:.3g}"
    whole = _tile(studio, material, caption, lines)
    studio.zoom(spot, plan.zoom)
    near = _tile(studio, material, "close-up", lines)
    return [Tile(whole.pixels, whole.caption, marked=box), Tile(near.pixels, near.caption, bordered=True)]


def _isolines(
    addon: ModuleType, obj: bpy.types.Object, count: int, window: tuple[float, float] | None = None
) -> bpy.types.Object:
    """The object's isolines, made anew."""
    settings = obj.dirichlet
    settings.levels_mode, settings.count, settings.output = "EVEN", count, "CURVE"
    if window:
        settings.window_low, settings.window_high = window
    settings.window_auto = window is None
    return part(addon, "blender.pipeline").make_isolines(obj).object


def _tile(studio: Studio, material: bpy.types.Material, caption: str, lines: bpy.types.Object | None = None) -> Tile:
    studio.dress(material)
    studio.draw(lines, _LINE)
    return Tile(studio.render(), caption)


def _busiest(studio: Studio, lines: bpy.types.Object, zoom: float) -> tuple[float, float]:
    """Where in the picture most of the lines' points are seen."""
    matrix = np.array(studio.surface.matrix_world)
    points = np.array([point.co[:3] for spline in lines.data.splines for point in spline.points]).reshape(-1, 3)
    places, depth = studio.project(points @ matrix[:3, :3].T + matrix[:3, 3])
    around, behind = studio.project(studio.points)
    cells, depths = _CELLS * np.concatenate((places, around)), np.concatenate((depth, behind))
    return busiest_spot(places[visible(cells, depths, 0.04 * np.ptp(behind))[: len(places)]], zoom)


def _limits(addon: ModuleType, obj: bpy.types.Object) -> tuple[float, float]:
    return part(addon, "blender.look.ramp").limits(part(addon, "blender.mesh.attributes").read_field(obj.data))


def _legend(addon: ModuleType, obj: bpy.types.Object, window: tuple[float, float]) -> Legend:
    low, high = _limits(addon, obj)
    linear = part(addon, "blender.look.ramp").read_table(obj).apply(np.linspace(low, high, 512), (low, high))
    bytes_ = part(addon, "library").load("ramps").srgb_bytes(linear[:, :3])
    return Legend(bytes_.astype(np.float32) / 255, low, high, window)
