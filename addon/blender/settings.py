# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings that several property groups share."""

from __future__ import annotations

import bpy

_LAST = "window_auto"  # setting an end of the window switches it off


def copy(source: bpy.types.PropertyGroup, target: bpy.types.PropertyGroup) -> None:
    """Gives target every value that both groups keep. What is equal already is not written: nothing is triggered."""
    for name in sorted(_kept(source) & _kept(target), key=lambda name: (name == _LAST, name)):
        value = getattr(source, name)
        if getattr(target, name) != value:
            setattr(target, name, value)


def _kept(group: bpy.types.PropertyGroup) -> set[str]:
    """Names of its properties but those that are derived from others, which are marked SKIP_SAVE."""
    return {found.identifier for found in group.bl_rna.properties if not found.is_skip_save} - {"rna_type", "name"}
