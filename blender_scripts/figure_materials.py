# SPDX-License-Identifier: GPL-3.0-or-later
"""What the surface and the lines of a figure wear. Colours are linear RGB."""

from __future__ import annotations

from types import ModuleType

import bpy
import numpy as np
from addon_loader import part
from numpy.typing import NDArray

CLAY = (0.62, 0.62, 0.62)
_RED = (0.72, 0.015, 0.02)
_INK = (0.012, 0.012, 0.03)
_PALE = (0.7, 0.7, 0.7)  # what colours fade to outside a window
_FADE = 0.85
_MASK = "figure_mask"


def ink(addon: ModuleType) -> bpy.types.Material:
    material, surface = part(addon, "blender.look.material").new_with_nodes("Ink")
    surface.inputs["Base Color"].default_value = (*_INK, 1)
    return _matte(material)


def painted(addon: ModuleType, mesh: bpy.types.Mesh, mask: NDArray[np.bool_]) -> bpy.types.Material:
    """Red where the mask (V,) is set, grey elsewhere."""
    mesh.attributes.new(_MASK, "FLOAT", "POINT").data.foreach_set("value", mask.astype(np.float32))
    material, surface = part(addon, "blender.look.material").new_with_nodes("Painted")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    attribute, ramp = nodes.new("ShaderNodeAttribute"), nodes.new("ShaderNodeValToRGB")
    attribute.attribute_name = _MASK
    part(addon, "blender.look.material").set_stops(ramp.color_ramp, ((0.3, CLAY), (0.7, _RED)))
    links.new(attribute.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], surface.inputs["Base Color"])
    return _matte(material)


def colored(addon: ModuleType, obj: bpy.types.Object) -> bpy.types.Material:
    """A copy of the object's field material."""
    return _matte(part(addon, "blender.look.material").find(obj).copy())


def fade_outside(addon: ModuleType, ramp: bpy.types.ColorRamp, low: float, high: float) -> None:
    """Bleaches a ramp outside [low, high] of its own [0, 1]."""

    def color(place: float, pale: bool) -> tuple[float, ...]:
        full = np.array(ramp.evaluate(place)[:3])
        return tuple(full + _FADE * (np.array(_PALE) - full) if pale else full)

    inner = [stop.position for stop in ramp.elements if low < stop.position < high]
    outer = {0.0, 1.0, *(stop.position for stop in ramp.elements if not low <= stop.position <= high)}
    step = 1e-5  # a jump takes two stops
    stops = [(place, color(place, True)) for place in (*outer, low - step, high + step) if 0 <= place <= 1]
    stops += [(place, color(place, False)) for place in (low, *inner, high)]
    part(addon, "blender.look.material").set_stops(ramp, sorted(stops))


def _matte(material: bpy.types.Material) -> bpy.types.Material:
    surface = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    surface.inputs["Roughness"].default_value = 0.65
    gloss = "Specular" if bpy.app.version < (4, 0, 0) else "Specular IOR Level"
    surface.inputs[gloss].default_value = 0.15
    return material
