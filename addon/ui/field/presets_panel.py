# SPDX-License-Identifier: GPL-3.0-or-later
"""Where presets are chosen, kept and removed, and settings copied."""

from contextlib import suppress
from pathlib import Path

import bpy
from bl_ui.utils import PresetPanel

from .preset_operators import SUBDIRECTORY
from .presets import PRESETS


class DIRICHLET_PT_presets(PresetPanel, bpy.types.Panel):
    bl_label = "Presets"
    bl_space_type = "VIEW_3D"
    preset_subdir = SUBDIRECTORY
    preset_operator = "dirichlet.apply_preset"
    preset_add_operator = "dirichlet.preset_add"
    preset_extensions = {".py"}

    def draw(self, context):
        with suppress(OSError):  # without it the list complains; another Blender may have removed it when it ended
            _folder().mkdir(parents=True, exist_ok=True)
        layout = self.layout
        layout.emboss = "PULLDOWN_MENU"
        layout.operator_context = "EXEC_DEFAULT"
        column = layout.column(align=True)
        for name, preset in PRESETS.items():
            column.operator("dirichlet.apply_preset", text=preset.label).preset = name
        layout.separator()
        PresetPanel.draw(self, context)
        layout.separator()
        layout.operator("dirichlet.copy_settings", icon="COPYDOWN")


def _draw_copy(menu: bpy.types.Menu, context: bpy.types.Context) -> None:
    menu.layout.separator()
    menu.layout.operator("dirichlet.copy_settings", text="Copy Isoline Settings")


def _folder() -> Path:
    """Where the user's presets are kept."""
    return Path(bpy.utils.user_resource("SCRIPTS", path=f"presets/{SUBDIRECTORY}"))


def register() -> None:
    bpy.types.VIEW3D_MT_make_links.append(_draw_copy)


def unregister() -> None:
    bpy.types.VIEW3D_MT_make_links.remove(_draw_copy)
    with suppress(OSError):  # it holds presets, and those stay
        _folder().rmdir()


CLASSES = (DIRICHLET_PT_presets,)
