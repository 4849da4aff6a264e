# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines in the 3D viewports, drawn straight from their arrays: nothing is added to the file."""

from __future__ import annotations

import math
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple

import bpy
import gpu
from bpy.app.handlers import persistent
from mathutils import Matrix

from .draw_handler import DrawHandler

_PULL = 2.0  # line widths towards the viewer, by which a line clears the slanting surface under it
_DEPTH_STEPS = 2.0**-22  # two steps of a depth buffer of 24 bits, over -1 to 1
_RIM = (0.0, 0.0, 0.0, 0.5)

_drawn: dict[int, _Drawn] = {}  # by the address of the object


class _Drawn(NamedTuple):
    """What the graphics card has of an object's Preview."""

    version: int
    batch: gpu.types.GPUBatch | None  # None: there is nothing to draw, or it cannot be drawn


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
    from ..blender import live

    for obj in _shown(bpy.context):
        preview, key = live.preview_of(obj), obj.as_pointer()
        if preview is None:
            continue
        try:
            if key not in _drawn or _drawn[key].version != preview.version:
                _forget_unused()
                _drawn[key] = _Drawn(preview.version, _build(preview))
            if _drawn[key].batch:
                _draw_lines(obj, _drawn[key].batch)
        except Exception:
            _drawn[key] = _Drawn(preview.version, None)
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


def _build(preview) -> gpu.types.GPUBatch | None:
    """preview: blender.live.Preview"""
    from ..blender import preview_geometry

    points, colors, segments = preview_geometry.segments(preview.lines, preview.colors)
    if not len(segments):
        return None
    layout = gpu.types.GPUVertFormat()
    layout.attr_add(id="pos", comp_type="F32", len=3, fetch_mode="FLOAT")
    layout.attr_add(id="color", comp_type="F32", len=4, fetch_mode="FLOAT")
    vertices = gpu.types.GPUVertBuf(layout, len(points))
    vertices.attr_fill("pos", points)
    vertices.attr_fill("color", colors)
    return gpu.types.GPUBatch(type="LINES", buf=vertices, elem=gpu.types.GPUIndexBuf(type="LINES", seq=segments))


def _draw_lines(obj: bpy.types.Object, batch: gpu.types.GPUBatch) -> None:
    """Lines of their levels' colours over wider dark ones, since the surface under them may have the same colours."""
    settings, pixel = obj.dirichlet, bpy.context.preferences.system.pixel_size
    width, height = settings.preview_width * pixel, gpu.state.viewport_get()[3]
    with _state("NONE" if settings.preview_xray else "LESS_EQUAL"):
        _pull(_PULL * width / height)
        gpu.matrix.multiply_matrix(obj.matrix_world)
        rim = _shader("POLYLINE_UNIFORM_COLOR", width + 2 * pixel)
        rim.uniform_float("color", _RIM)
        batch.draw(rim)
        batch.draw(_shader("POLYLINE_FLAT_COLOR", width))


def _shader(name: str, width: float) -> gpu.types.GPUShader:
    shader = gpu.shader.from_builtin(name)
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    shader.uniform_float("lineWidth", width)
    shader.uniform_bool("lineSmooth", [True])
    return shader


def _pull(part: float) -> None:
    """Moves what is drawn next towards the viewer, and not across the picture: by a part of the picture's height as
    seen at its distance, which serves near and far, large and small; and by what the depth buffer can tell apart."""
    projection, view = gpu.matrix.get_projection_matrix(), gpu.matrix.get_model_view_matrix()
    distance = part * 2.0 / projection[1][1]
    if projection[3][3] == 0.0:  # perspective
        nearer = Matrix.Scale(max(1.0 - distance, 0.5), 4)
    else:
        nearer = Matrix.Translation((0.0, 0.0, distance))
    gpu.matrix.load_matrix(nearer @ view)
    shallower = Matrix.Identity(4)
    shallower[2][3] = math.copysign(_DEPTH_STEPS, projection[2][2])  # whichever way depth is counted
    gpu.matrix.load_projection_matrix(shallower @ projection)


@contextmanager
def _state(depth_test: str) -> Iterator[None]:
    state = gpu.state
    before = state.depth_test_get(), state.depth_mask_get(), state.blend_get()
    state.depth_test_set(depth_test)
    state.depth_mask_set(False)
    state.blend_set("ALPHA")
    try:
        with gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
            yield
    finally:
        state.depth_test_set(before[0])
        state.depth_mask_set(before[1])
        state.blend_set(before[2])


_handler = DrawHandler(_draw, "POST_VIEW")
