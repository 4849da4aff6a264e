# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of patches."""

import bpy


class DIRICHLET_UL_patches(bpy.types.UIList):
    """One row per patch: on or off, vertex group, value. Red when its group does not exist."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_propname, index=0, flt_flag=0):
        missing = item.group not in item.id_data.vertex_groups
        row = layout.row(align=True)
        row.prop(item, "enabled", text="")
        cells = row.split(factor=0.6)
        cells.active = item.enabled
        name = cells.row()
        name.alert = missing
        name.label(text=item.group or "no group", icon="ERROR" if missing else "NONE")
        if item.weights_as_values:
            cells.label(text="weights")
        else:
            cells.prop(item, "value", text="", emboss=False)


CLASSES = (DIRICHLET_UL_patches,)
