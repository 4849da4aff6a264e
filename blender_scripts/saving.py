# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's own files, as writers for the library's all-or-nothing `write_all`."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import bpy
import figure_materials
from addon_loader import part
from figure_scene import Studio
from figure_sheet import Sheet
from figure_views import best_view

_LINE = 0.004  # width of a line, as a fraction of the picture's height


def save_blend(path: Path) -> None:
    """A copy of the open file. Raises OSError where it cannot be written."""
    try:
        bpy.ops.wm.save_as_mainfile(filepath=str(path.absolute()), copy=True, check_existing=False)
    except RuntimeError as error:
        raise OSError(str(error).strip()) from error


def render_object(addon: ModuleType, obj: bpy.types.Object, size: tuple[int, int], path: Path) -> None:
    """The object's field with its isolines, from the side that shows most of it and of its paint, on white.

    Raises OSError where the picture cannot be written.
    """
    painted = part(addon, "blender.paint.painting").read_painting(obj).vertices
    with Studio(addon, obj, *size) as studio:
        studio.look(best_view(studio.points, painted))
        studio.dress(figure_materials.colored(addon, obj))
        studio.draw(part(addon, "blender.lines.result_objects").find(obj), _LINE)
        tile = studio.render()
    sheet = Sheet(*size)
    sheet.paste(tile, 0, 0)
    sheet.save(path)
