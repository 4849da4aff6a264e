# SPDX-License-Identifier: GPL-3.0-or-later
"""Stripes in the field material: the node group Dirichlet Stripes and a Mix node, which lays the lines' colour over
whatever the ramp's colours went to before."""

from __future__ import annotations

import bpy
import numpy as np

from ... import library
from ...language import say
from ..lines import levels, line_task
from . import material, stripe_nodes

_MIX = "Dirichlet Stripe Color"


def find(obj: bpy.types.Object) -> bpy.types.ShaderNodeGroup | None:
    """The node with the stripes' inputs, in the object's field material."""
    found = material.find(obj)
    return next(filter(stripe_nodes.is_stripes, found.node_tree.nodes), None) if found else None


def find_color(obj: bpy.types.Object) -> bpy.types.NodeSocket | None:
    """The input with the lines' colour."""
    found = material.find(obj)
    mix = found.node_tree.nodes.get(_MIX) if found else None
    return _sockets(mix)[2] if mix else None


def add(obj: bpy.types.Object) -> bpy.types.ShaderNodeGroup:
    """Stripes at the levels that Make Isolines would take; those that are there already stay as they are.

    Raises InputError without a field or its material, or when the levels are not evenly spaced."""
    settings = _settings(obj)
    owner = material.require_own(obj)
    return find(obj) or _insert(owner.node_tree, settings)


def match(obj: bpy.types.Object) -> None:
    """Moves the stripes to the levels that Make Isolines would take. Raises InputError as `add` does."""
    settings = _settings(obj)
    material.require_own(obj)
    _set(find(obj), settings)


def remove(obj: bpy.types.Object) -> None:
    """Takes the stripes out, and the node group out of the file when nothing else uses it."""
    tree = material.require_own(obj).node_tree
    stripes, mix = find(obj), tree.nodes.get(_MIX)
    if mix:
        _, below, _, shown = _sockets(mix)
        for link in below.links:
            for target in [found.to_socket for found in shown.links]:
                tree.links.new(link.from_socket, target)
        tree.nodes.remove(mix)
    group = stripes.node_tree
    tree.nodes.remove(stripes)
    if not group.users:
        bpy.data.node_groups.remove(group)


def _insert(tree: bpy.types.NodeTree, settings: dict[str, float]) -> bpy.types.ShaderNodeGroup:
    color = material.color_output(tree)
    targets = [link.to_socket for link in color.links]
    x, y = color.node.location
    stripes = material.add_node(tree.nodes, "ShaderNodeGroup", (x, y + 400), stripe_nodes.NAME)
    stripes.node_tree = stripe_nodes.group()
    _set(stripes, settings)
    mix = material.add_node(tree.nodes, "ShaderNodeMix", (x + 180, y), _MIX)
    mix.data_type = "RGBA"
    factor, below, lines, shown = _sockets(mix)
    lines.default_value = (0.0, 0.0, 0.0, 1.0)
    tree.links.new(stripes.outputs["Mask"], factor)
    tree.links.new(color, below)
    for target in targets:
        tree.links.new(shown, target)
    return stripes


def _settings(obj: bpy.types.Object) -> dict[str, float]:
    """The group's inputs that choose the levels."""
    options, values = levels.read_options(obj.dirichlet), line_task.read_values(obj)
    if options.mode not in ("EVEN", "STEP"):
        raise library.load().InputError(
            say(
                "stripes are evenly spaced, the levels of object '{object}' are not: choose Even or Step for its "
                "Levels",
                object=obj.name,
            )
        )
    field_range = float(np.fmin.reduce(values)), float(np.fmax.reduce(values))
    options.choose(*field_range)  # refuses what cannot be drawn
    low, high = options.window or field_range
    if options.mode == "EVEN":
        return {"Low": low, "High": high, "Count": options.count, "Phase": 0.0}
    phase = (options.phase - low / options.step - 0.5) % 1.0  # the lines at multiples of the step
    return {"Low": low, "High": high, "Count": (high - low) / options.step, "Phase": phase}


def _set(stripes: bpy.types.ShaderNodeGroup, settings: dict[str, float]) -> None:
    for name, value in settings.items():
        stripes.inputs[name].default_value = value


def _sockets(mix: bpy.types.ShaderNodeMix) -> tuple[bpy.types.NodeSocket, ...]:
    """Factor, colour below, colour above, result."""
    return tuple(socket for socket in (*mix.inputs, *mix.outputs) if socket.enabled)
