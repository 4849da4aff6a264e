# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over the surface in the 3D viewports while an operator runs."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import bpy
import gpu
from gpu_extras.batch import batch_for_shader

_WIDTHS = ((4.0, (0.0, 0.0, 0.0, 0.6)), (2.0, (1.0, 1.0, 1.0, 1.0)))  # white on black shows on every colour


class Outline:
    """Shows lines in an object's space, in front of all, until it is removed."""

    def __init__(self, obj: bpy.types.Object) -> None:
        self._matrix = obj.matrix_world.copy()
        self._batches: list[gpu.types.GPUBatch] = []
        self._handle: Any = bpy.types.SpaceView3D.draw_handler_add(self._draw, (), "WINDOW", "POST_VIEW")

    def set(self, lines: Any) -> None:
        """lines: the library's Isolines."""
        ends = pairwise(lines.offsets.tolist())
        pieces = (
            (lines.points[start:end].tolist(), "LINE_LOOP" if closed else "LINE_STRIP")
            for (start, end), closed in zip(ends, lines.closed.tolist())
        )
        self._batches = [batch_for_shader(_shader(), kind, {"pos": points}) for points, kind in pieces]

    def remove(self) -> None:
        if self._handle:
            bpy.types.SpaceView3D.draw_handler_remove(self._handle, "WINDOW")
        self._handle = None

    def _draw(self) -> None:
        shader = _shader()
        gpu.state.blend_set("ALPHA")
        with gpu.matrix.push_pop():
            gpu.matrix.multiply_matrix(self._matrix)
            for width, color in _WIDTHS:
                shader.bind()
                shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
                shader.uniform_float("lineWidth", width * bpy.context.preferences.system.pixel_size)
                shader.uniform_float("color", color)
                for batch in self._batches:
                    batch.draw(shader)
        gpu.state.blend_set("NONE")


def _shader() -> gpu.types.GPUShader:
    prefix = "3D_" if bpy.app.version < (4, 0, 0) else ""
    return gpu.shader.from_builtin(f"{prefix}POLYLINE_UNIFORM_COLOR")
