# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawing into the 3D viewports."""

from collections.abc import Callable

import bpy


class DrawHandler:
    """Calls a function whenever a 3D viewport is drawn. One that fails says so once, with its traceback, and rests
    until it is registered again: at every redraw it would flood the console."""

    def __init__(self, draw: Callable[[], None], moment: str) -> None:
        """moment: POST_VIEW, in the space of the scene, or POST_PIXEL, in pixels of the region."""
        self._draw_function = draw
        self._moment = moment
        self.handle = None  # Blender's, while it draws; in background it never does
        self._failed = False

    def register(self) -> None:
        self._failed = False
        if not bpy.app.background:
            self.handle = bpy.types.SpaceView3D.draw_handler_add(self.draw, (), "WINDOW", self._moment)

    def unregister(self) -> None:
        if self.handle:
            bpy.types.SpaceView3D.draw_handler_remove(self.handle, "WINDOW")
        self.handle = None

    def draw(self) -> None:
        """What Blender calls."""
        if self._failed:
            return
        try:
            self._draw_function()
        except Exception:
            self._failed = True
            raise
