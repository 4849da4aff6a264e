# SPDX-License-Identifier: GPL-3.0-or-later
"""How the settings of isolines are laid out, for the mesh object and for results."""

import bpy

_OF_MODE = {"STEP": ("step", "phase")}


def draw_line_settings(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup, *, picking: bool = False) -> None:
    """settings: a LineSettings; picking: they are the active object's, whose levels can be picked on it."""
    row = layout.row(align=True)
    row.prop(settings, "levels_mode", text="")
    if picking:
        row.operator("dirichlet.pick_level", text="", icon="EYEDROPPER")
    column = properties(layout, animated=True)
    if settings.levels_mode == "LIST":
        column.prop(settings, "levels_list")
    else:
        for name in _OF_MODE.get(settings.levels_mode, ("count",)):
            column.prop(settings, name)
        properties(column).prop(settings, "window_auto")
        window = column.column(align=True)
        window.active = not settings.window_auto
        window.prop(settings, "window_low")
        window.prop(settings, "window_high")
    column.separator()
    column.prop(settings, "bevel_depth")
    column.prop(settings, "output")


def draw_line_shape(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    """settings: a LineSettings."""
    column = properties(layout, animated=True)
    for name in ("min_length", "smooth", "resample", "simplify"):
        column.prop(settings, name)
    column.separator()
    bevel = column.column(align=True)
    bevel.prop(settings, "bevel_low")
    bevel.prop(settings, "bevel_high")


def draw_lock(layout: bpy.types.UILayout, note: bpy.types.PropertyGroup) -> None:
    """note: a DirichletIsolines."""
    layout.prop(note, "locked", text="", icon="LOCKED" if note.locked else "UNLOCKED")


def properties(layout: bpy.types.UILayout, *, animated: bool = False) -> bpy.types.UILayout:
    """A column of properties with their names on the left, and the dots that set keyframes on the right if wanted."""
    column = layout.column()
    column.use_property_split = True
    column.use_property_decorate = animated
    return column
