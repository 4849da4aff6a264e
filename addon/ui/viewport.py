# SPDX-License-Identifier: GPL-3.0-or-later
"""How the 3D viewports show the mesh."""

import bpy


def show_vertex_colors(context: bpy.types.Context) -> None:
    """Colours solid viewports of this window by the active colour attribute; the other shadings show the material."""
    for area in context.screen.areas if context.screen else ():
        if area.type == "VIEW_3D" and area.spaces.active.shading.type == "SOLID":
            area.spaces.active.shading.color_type = "VERTEX"
