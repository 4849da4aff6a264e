# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of patches."""

import bpy

from ...language import label

_WIDE = 360  # width of the sidebar, in units of the interface, from which there is room for counts and number fields


class DIRICHLET_UL_patches(bpy.types.UIList):
    """One row per patch: on or off, colour, vertex group, a warning that explains itself, and the value."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_propname, index=0, flt_flag=0):
        missing = item.group not in item.id_data.vertex_groups
        wide = context.region.width > _WIDE * context.preferences.system.ui_scale
        row = layout.row(align=True)
        row.prop(item, "enabled", text="")
        cells = row.row(align=True)
        cells.active = item.enabled
        _cell(cells, 0.8).prop(item, "color", text="")
        name = cells.row()
        name.alert = missing
        name.label(text=item.group or label("no group"), icon="ERROR" if missing else "NONE", translate=False)
        if item.problem and not missing:
            warning = cells.operator("dirichlet.check_patches", text="", icon="ERROR", emboss=False)
            warning.index = index
        if wide:
            _label(cells, 3.0, f"{item.vertices:,}" if item.vertices else "")
        if item.weights_as_values:
            _label(cells, 3.0 if wide else 2.2, label("weights"))
        elif wide:
            _cell(cells, 3.6).prop(item, "value", text="", emboss=False)
        else:  # a number field cuts off digits here; there is one below the list
            _label(cells, 2.2, f"{item.value:.4g}")


def draw_patch_list(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    """The list, with the buttons for its rows beside it. settings: Object.dirichlet"""
    row = layout.row()
    row.template_list("DIRICHLET_UL_patches", "", settings, "patches", settings, "active_patch", rows=7)
    column = row.column(align=True)
    column.operator("dirichlet.patch_add_group", text="", icon="ADD").group = ""
    column.operator("dirichlet.patch_remove", text="", icon="REMOVE")
    column.operator("dirichlet.patch_duplicate", text="", icon="DUPLICATE")
    column.separator()
    column.operator("dirichlet.patch_move", text="", icon="TRIA_UP").direction = "UP"
    column.operator("dirichlet.patch_move", text="", icon="TRIA_DOWN").direction = "DOWN"
    column.separator()
    column.operator("dirichlet.patch_paint", text="", icon="BRUSH_DATA")


def _label(row: bpy.types.UILayout, width: float, text: str) -> None:
    cell = _cell(row, width)
    cell.alignment = "RIGHT"
    cell.label(text=text, translate=False)


def _cell(row: bpy.types.UILayout, width: float) -> bpy.types.UILayout:
    """Part of a row with a width of its own, in heights of a button."""
    cell = row.row(align=True)
    cell.ui_units_x = width
    return cell


CLASSES = (DIRICHLET_UL_patches,)
