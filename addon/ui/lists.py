# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of patches."""

import bpy


class DIRICHLET_UL_patches(bpy.types.UIList):
    """One row per patch: on or off, vertex group, value, weights as values. Red when its group does not exist."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_propname, index=0, flt_flag=0):
        obj = item.id_data
        row = layout.row(align=True)
        row.prop(item, "enabled", text="")
        line = row.row(align=True)
        line.active = item.enabled
        name = line.split(factor=0.6, align=True)
        group = name.row(align=True)
        missing = item.group not in obj.vertex_groups
        group.alert = missing
        group.prop_search(
            item, "group", obj, "vertex_groups", text="", icon="ERROR" if missing else "GROUP_VERTEX"
        )
        value = name.row(align=True)
        if item.weights_as_values:
            value.label(text="weights")
        else:
            value.prop(item, "value", text="")
        value.prop(item, "weights_as_values", text="", icon="MOD_VERTEX_WEIGHT", toggle=True)


CLASSES = (DIRICHLET_UL_patches,)
