# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines over the surface in the 3D viewports while an operator runs."""

from __future__ import annotations

from typing import Any

import bpy
import gpu

from ..drawing import line_drawing
from ..drawing.draw_handler import DrawHandler

_WIDTH = 2.0


class Outline:
    """Shows lines in an object's space, in front of everything, until it is removed."""

    def __init__(self, obj: bpy.types.Object) -> None:
        self._matrix = obj.matrix_world.copy()
        self._batch: gpu.types.GPUBatch | None = None
        self._handler = DrawHandler(self._draw, "POST_VIEW")
        self._handler.register()

    def set(self, lines: Any, colors: Any) -> None:
        """As line_drawing.build takes them."""
        self._batch = line_drawing.build(lines, colors)

    def remove(self) -> None:
        self._handler.unregister()

    def _draw(self) -> None:
        if self._batch:
            line_drawing.draw(self._batch, self._matrix, _WIDTH, hidden=False)
