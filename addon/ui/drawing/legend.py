# SPDX-License-Identifier: GPL-3.0-or-later
"""The active object's ramp at the left side of the 3D viewports, with range, window and levels."""

from __future__ import annotations

import blf
import bpy
import gpu
from gpu_extras.batch import batch_for_shader

from .draw_handler import DrawHandler

_WIDTH, _HEIGHT = 14, 280  # of the bar, in points of the interface
_MARGIN = 16
_FONT, _FONT_SIZE = 0, 11


def _draw() -> None:
    context = bpy.context
    obj = context.active_object
    if obj and obj.type == "MESH" and context.space_data.overlay.show_overlays:
        settings = obj.dirichlet
        if settings.legend and settings.results.solved:
            _draw_legend(context, obj)


def _draw_legend(context: bpy.types.Context, obj: bpy.types.Object) -> None:
    from ...blender.look import legend_geometry

    scale, height = context.preferences.system.ui_scale, context.region.height
    tools = next(region.width for region in context.area.regions if region.type == "TOOLS")
    size = _WIDTH * scale, min(_HEIGHT * scale, 0.6 * height)
    corner = tools + _MARGIN * scale, (height - size[1]) / 2
    gpu.state.blend_set("ALPHA")
    with gpu.matrix.push_pop():
        gpu.matrix.translate(corner)
        gpu.matrix.scale(size)
        _draw_bar(obj)
    gpu.state.blend_set("NONE")
    blf.size(_FONT, _FONT_SIZE * scale)
    blf.color(_FONT, 1.0, 1.0, 1.0, 1.0)
    blf.enable(_FONT, blf.SHADOW)
    blf.shadow(_FONT, 3, 0.0, 0.0, 0.0, 1.0)
    for place, text in legend_geometry.labels(obj):
        below = blf.dimensions(_FONT, text)[1] / 2
        blf.position(_FONT, corner[0] + 1.8 * size[0], corner[1] + place * size[1] - below, 0.0)
        blf.draw(_FONT, text)
    blf.disable(_FONT, blf.SHADOW)


def _draw_bar(obj: bpy.types.Object) -> None:
    """In the unit square."""
    from ...blender.look import legend_geometry

    window = legend_geometry.window(obj)
    shader = gpu.shader.from_builtin("SMOOTH_COLOR")
    points, colors = legend_geometry.bar(obj)
    batch_for_shader(shader, "TRI_STRIP", {"pos": points, "color": colors}).draw(shader)
    _fill("TRIS", legend_geometry.shades(window), (0.0, 0.0, 0.0, 0.6))
    _fill("LINES", legend_geometry.ticks(obj), (0.0, 0.0, 0.0, 1.0))
    _fill("TRIS", legend_geometry.marks(window), (1.0, 1.0, 1.0, 1.0))


def _fill(kind: str, points, color: tuple[float, float, float, float]) -> None:
    if len(points):
        shader = gpu.shader.from_builtin("UNIFORM_COLOR")
        batch = batch_for_shader(shader, kind, {"pos": points})
        shader.bind()
        shader.uniform_float("color", color)
        batch.draw(shader)


_handler = DrawHandler(_draw, "POST_PIXEL")
register, unregister = _handler.register, _handler.unregister
