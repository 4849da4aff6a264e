# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines in the 3D viewports, drawn straight from their arrays: nothing is added to the file."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

import bpy
import gpu
from bpy.app.handlers import persistent

from ...blender.lines import result_objects
from . import line_drawing
from .draw_handler import DrawHandler

if TYPE_CHECKING:
    from ...blender.follower import Preview  # brings NumPy

_drawn: dict[int, _Drawn] = {}  # by the address of the object


class _Drawn:
    """An object's Preview as it is drawn over and over."""

    def __init__(self, preview: Preview) -> None:
        from ...blender.lines import preview_geometry

        self.version, self._colors = preview.version, preview.colors
        self.shown = preview_geometry.Shown(preview.lines)

    @cached_property
    def batch(self) -> gpu.types.GPUBatch | None:
        """What the graphics card has of it. None: there is nothing to draw, or it cannot be drawn."""
        return line_drawing.build(self.shown.lines, self._colors)


def register() -> None:
    _handler.register()
    bpy.app.handlers.load_post.append(_loaded)


def unregister() -> None:
    bpy.app.handlers.load_post.remove(_loaded)
    _handler.unregister()
    _drawn.clear()


@persistent
def _loaded(path) -> None:
    _drawn.clear()


def _draw() -> None:
    """Draws the lines of all objects that this viewport shows.

    Lines that cannot be drawn are said once, with the traceback, and left out until they change.
    """
    from ...blender import live

    for obj in _shown(bpy.context):
        preview, key = live.preview_of(obj), obj.as_pointer()
        if preview is None:
            _drawn.pop(key, None)
            continue
        if key not in _drawn or _drawn[key].version != preview.version:
            _forget_unused()
            _drawn[key] = _Drawn(preview)
        drawn = _drawn[key]
        try:
            if drawn.batch and not _is_drawn_already(obj, drawn):
                _draw_lines(obj, drawn.batch)
        except Exception:
            import traceback

            drawn.batch = None
            traceback.print_exc()


def _forget_unused() -> None:
    used = {obj.as_pointer() for obj in bpy.data.objects if obj.dirichlet.preview}
    for key in _drawn.keys() - used:
        del _drawn[key]


def _shown(context: bpy.types.Context) -> Iterator[bpy.types.Object]:
    space, layer = context.space_data, context.view_layer
    if space.overlay.show_overlays:
        for obj in layer.objects:
            if obj.type == "MESH" and obj.dirichlet.preview and obj.visible_get(view_layer=layer, viewport=space):
                yield obj


def _is_drawn_already(obj: bpy.types.Object, drawn: _Drawn) -> bool:
    """Whether this viewport shows a result of the same lines; through surfaces only the preview is seen."""
    from ...blender.lines import preview_geometry

    result, context = result_objects.find(obj), bpy.context
    if result is None or obj.dirichlet.preview_xray:
        return False
    visible = result.visible_get(view_layer=context.view_layer, viewport=context.space_data)
    return visible and preview_geometry.is_drawn_by(result, drawn.shown)


def _draw_lines(obj: bpy.types.Object, batch: gpu.types.GPUBatch) -> None:
    settings = obj.dirichlet
    line_drawing.draw(batch, obj.matrix_world, settings.preview_width, hidden=not settings.preview_xray)


_handler = DrawHandler(_draw, "POST_VIEW")
