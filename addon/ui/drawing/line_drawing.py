# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over surfaces in the 3D viewports."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import bpy
import gpu
from mathutils import Matrix

_PULL = 2.0  # line widths towards the viewer, by which a line clears the slanting surface under it
_DEPTH_STEPS = 2.0**-22  # two steps of a depth buffer of 24 bits, over -1 to 1
_RIM = (0.0, 0.0, 0.0, 0.5)


def build(lines: Any, colors: Any) -> gpu.types.GPUBatch | None:
    """What the graphics card takes of lines; None when there is nothing to draw.

    lines: the library's Isolines; colors: (K, 4) float32 linear, one per level.
    """
    from ...blender.lines import preview_geometry

    points, shown, segments = preview_geometry.segments(lines, colors)
    if not len(segments):
        return None
    layout = gpu.types.GPUVertFormat()
    layout.attr_add(id="pos", comp_type="F32", len=3, fetch_mode="FLOAT")
    layout.attr_add(id="color", comp_type="F32", len=4, fetch_mode="FLOAT")
    vertices = gpu.types.GPUVertBuf(layout, len(points))
    vertices.attr_fill("pos", points)
    vertices.attr_fill("color", shown)
    return gpu.types.GPUBatch(type="LINES", buf=vertices, elem=gpu.types.GPUIndexBuf(type="LINES", seq=segments))


def draw(batch: gpu.types.GPUBatch, matrix: Matrix, width: float, *, hidden: bool) -> None:
    """Lines of their levels' colours over wider dark ones, since the surface under them may have the same colours.

    matrix: from the lines' space to the world's; width: in points of the interface; hidden: where surfaces hide them.
    """
    pixel, height = bpy.context.preferences.system.pixel_size, gpu.state.viewport_get()[3]
    with _state("LESS_EQUAL" if hidden else "NONE"):
        _pull(_PULL * width * pixel / height)
        gpu.matrix.multiply_matrix(matrix)
        rim = _shader("POLYLINE_UNIFORM_COLOR", (width + 2) * pixel)
        rim.uniform_float("color", _RIM)
        batch.draw(rim)
        batch.draw(_shader("POLYLINE_FLAT_COLOR", width * pixel))


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
