# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of isolines. Those made here are tagged; others in the slots are the user's and stay."""

from __future__ import annotations

import bpy
import numpy as np
from numpy.typing import NDArray

from ...look import material
from ...names import COLOR

_TAG = "dirichlet_isoline"


def set_slots(slots: bpy.types.IDMaterials, name: str, colors: NDArray[np.float32]) -> None:
    """One slot per colour (N, 4): materials made here are recoloured, those the user put there instead stay."""
    for k, color in enumerate(colors.tolist()):
        if k == len(slots):
            slots.append(None)
        if slots[k] is None:
            slots[k] = material.new_with_nodes(f"{name} isoline {k + 1}")[0]
            slots[k][_TAG] = True
        if _TAG in slots[k]:
            _recolor(slots[k], color)
    while len(slots) > len(colors) and (slots[-1] is None or _TAG in slots[-1]):
        remove_spare([slots.pop()])


def show_attribute(slots: bpy.types.IDMaterials, name: str) -> None:
    """A material that shows the attribute dirichlet_color, unless there is one already."""
    if len(slots):
        return
    made, surface = material.new_with_nodes(f"{name} isolines")
    made[_TAG] = True
    color = made.node_tree.nodes.new("ShaderNodeAttribute")
    color.location = (-300, 300)
    color.attribute_name = COLOR
    made.node_tree.links.new(color.outputs["Color"], surface.inputs["Base Color"])
    slots.append(made)


def remove_spare(found: list[bpy.types.Material | None]) -> None:
    """Removes those that were made here and that nothing uses any more."""
    for spare in found:
        if spare and _TAG in spare and not spare.users:
            bpy.data.materials.remove(spare)


def _recolor(line_material: bpy.types.Material, color: list[float]) -> None:
    line_material.diffuse_color = color
    for node in line_material.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = color
