# SPDX-License-Identifier: GPL-3.0-or-later
"""The material of a field, Attribute -> Map Range -> ColorRamp -> Base Color, whose ramp is the one that users edit.

It is known by its nodes' names, so renaming, appending or linking it does no harm. It never takes the place of a user's
material on the mesh: there it stands on the object's side of the slot, and the mesh keeps its own.
"""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from ... import library
from ...language import say
from ..names import FIELD

_RAMP = "Dirichlet Ramp"
_RANGE = "Dirichlet Range"
_SHOWN = "Undefined or Ramp"

Stops = Sequence[tuple[float, Sequence[float]]]  # place, and RGB or RGBA


def find(obj: bpy.types.Object) -> bpy.types.Material | None:
    """The object's field material, if one of its slots has one."""
    return next((slot.material for slot in obj.material_slots if _is_ours(slot.material)), None)


def find_ramp(obj: bpy.types.Object) -> bpy.types.ShaderNodeValToRGB | None:
    """The node with the ramp of the object's field material."""
    material = find(obj)
    return material.node_tree.nodes[_RAMP] if material else None


def shown_on(material: bpy.types.Material, scene: bpy.types.Scene) -> list[bpy.types.Object]:
    """The mesh objects of the scene whose field material it is."""
    if not _is_ours(material):
        return []
    return [obj for obj in scene.objects if obj.type == "MESH" and find(obj) == material]


def show(
    obj: bpy.types.Object, ends: tuple[float, float], stops: Stops, undefined: tuple[float, float, float]
) -> list[str]:
    """Assigns the field material to every slot of the object, made with `stops` if there is none yet; `ends` are the
    values at the ends of its ramp, `undefined` is the colour where the field is NaN. Returns warnings."""
    material = _single_user(obj, find(obj) or _build(obj.name, stops, undefined))
    _set_range(material, ends)
    if not obj.material_slots:
        obj.data.materials.append(material)
    kept = [slot.material.name for slot in obj.material_slots if not _assign(slot, material)]
    return [say("material '{name}' is linked to the object, so it was left where it is", name=name) for name in kept]


def update_range(obj: bpy.types.Object, ends: tuple[float, float]) -> None:
    """As `show`, but leaves the slots as they are: the user may have put another material there."""
    material = find(obj)
    if material and not material.library:
        _set_range(_single_user(obj, material), ends)


def restore(obj: bpy.types.Object) -> None:
    """Shows the materials of the mesh again where the field's stands on the object's side of a slot."""
    for slot in obj.material_slots:
        if slot.link == "OBJECT" and _is_ours(slot.material):
            slot.link = "DATA"


def hides_others(obj: bpy.types.Object) -> bool:
    """Whether `restore` would change anything."""
    return any(slot.link == "OBJECT" and _is_ours(slot.material) for slot in obj.material_slots)


def set_stops(ramp: bpy.types.ColorRamp, stops: Stops) -> None:
    """Replaces all stops; linear interpolation of linear RGB."""
    ramp.color_mode, ramp.interpolation = "RGB", "LINEAR"
    while len(ramp.elements) > 1:
        ramp.elements.remove(ramp.elements[-1])
    ramp.elements[0].position = stops[0][0]
    for position, _ in stops[1:]:
        ramp.elements.new(position)
    for element, (_, color) in zip(ramp.elements, stops):
        element.color = (*color, 1.0)[:4]


def new_with_nodes(name: str) -> tuple[bpy.types.Material, bpy.types.ShaderNodeBsdfPrincipled]:
    """A material and its Principled BSDF."""
    material = bpy.data.materials.new(name)
    if bpy.app.version < (5, 0, 0):  # later ones always have nodes
        material.use_nodes = True
    return material, next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")


def require_own(obj: bpy.types.Object) -> bpy.types.Material:
    """The object's field material, copied first if other objects use it or it belongs to another file. Raises
    InputError when there is none."""
    found = find(obj)
    if found is None:
        raise library.load().InputError(
            say("object '{object}' has no field material: run Solve Field first", object=obj.name)
        )
    own = _single_user(obj, found)
    for slot in obj.material_slots:
        if slot.material == found:
            slot.material = own
    return own


def color_output(tree: bpy.types.NodeTree) -> bpy.types.NodeSocket:
    """Where the field's colours come out of the nodes made here."""
    node = tree.nodes.get(_SHOWN) or tree.nodes[_RAMP]
    return next(socket for socket in node.outputs if socket.enabled)


def add_node(nodes: bpy.types.Nodes, kind: str, location: tuple[int, int], name: str = "") -> bpy.types.Node:
    """A node at a place, with a name and label if one is given."""
    node = nodes.new(kind)
    node.location = location
    if name:
        node.name = node.label = name
    return node


def _is_ours(material: bpy.types.Material | None) -> bool:
    return bool(material and material.node_tree and {_RAMP, _RANGE} <= set(material.node_tree.nodes.keys()))


def _set_range(material: bpy.types.Material, ends: tuple[float, float]) -> None:
    limits = material.node_tree.nodes[_RANGE].inputs
    for name, end in zip(("From Min", "From Max"), ends):
        if limits[name].default_value != end:  # every write makes Blender evaluate the material again
            limits[name].default_value = end


def _assign(slot: bpy.types.MaterialSlot, material: bpy.types.Material) -> bool:
    """Whether the slot shows the material now: the user's own on the object's side is not replaced."""
    if slot.material and not _is_ours(slot.material):
        if slot.link == "OBJECT":
            return False
        slot.link = "OBJECT"
    if slot.material != material:
        slot.material = material
    return True


def _single_user(obj: bpy.types.Object, material: bpy.types.Material) -> bpy.types.Material:
    """The material, or a copy when other objects use it or it belongs to another file: a duplicated object gets a range
    and a ramp of its own."""
    ours = sum(slot.material == material for slot in obj.material_slots) + material.use_fake_user
    return material.copy() if material.library or material.users > ours else material


def _build(name: str, stops: Stops, undefined: tuple[float, float, float]) -> bpy.types.Material:
    material, surface = new_with_nodes(f"{name} field")
    nodes, links = material.node_tree.nodes, material.node_tree.links
    field = add_node(nodes, "ShaderNodeAttribute", (-1100, 200))
    field.attribute_name = FIELD
    scale = add_node(nodes, "ShaderNodeMapRange", (-900, 300), _RANGE)
    ramp = add_node(nodes, "ShaderNodeValToRGB", (-700, 300), _RAMP)
    set_stops(ramp.color_ramp, stops)
    defined = add_node(nodes, "ShaderNodeMath", (-700, 0), "Defined")
    defined.operation = "GREATER_THAN"  # than a number below all others: false for NaN alone
    defined.inputs[1].default_value = -3e38
    mix = add_node(nodes, "ShaderNodeMix", (-350, 200), _SHOWN)
    mix.data_type = "RGBA"
    factor, other, color = (socket for socket in mix.inputs if socket.enabled)
    other.default_value = (*undefined, 1.0)
    links.new(field.outputs["Fac"], scale.inputs["Value"])
    links.new(field.outputs["Fac"], defined.inputs[0])
    links.new(scale.outputs["Result"], ramp.inputs["Fac"])
    links.new(defined.outputs["Value"], factor)
    links.new(ramp.outputs["Color"], color)
    links.new(next(socket for socket in mix.outputs if socket.enabled), surface.inputs["Base Color"])
    return material
