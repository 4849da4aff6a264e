# SPDX-License-Identifier: GPL-3.0-or-later
"""The shader node group Dirichlet Stripes: isolines drawn by the shader, from the attribute that carries the field.

Its lines are where `even_levels(low, high, count)` of the library puts them, moved by the phase, strictly inside the
window. With x the field's place in the window, from 0 to 1, and s = x count − phase, the lines stand at s = c + 1/2 for
whole c; a point belongs to the line of c = floor(s), and is on it where |s − c − 1/2| is at most half of the width.
Widths are thus in steps of the field: on the surface a line is the wider, the less steep the field is.
"""

from __future__ import annotations

import bpy

from ..names import FIELD

NAME = "Dirichlet Stripes"
_TAG = "dirichlet_stripes"  # on the group, which may be renamed
_HAIR = 1e-5  # of the window: what a patch painted with one of its ends may stray from it by rounding

# name, default, lowest, highest, description
_INPUTS = (
    ("Low", 0.0, -1e30, 1e30, "Value of the field at the lower end of the window; lines are drawn inside it only"),
    ("High", 1.0, -1e30, 1e30, "Value of the field at the upper end of the window"),
    ("Count", 13.0, 0.0, 1e6, "Number of lines inside the window"),
    ("Phase", 0.0, -1e6, 1e6, "Shift of the lines in steps: from 0 to 1 every line moves to its neighbour"),
    ("Width", 0.15, 0.0, 1.0, "Width of a line, as a part of the step from one line to the next"),
    ("Softness", 0.0, 0.0, 1.0, "Width over which a line's edge fades, as a part of the step"),
)
_OUTPUTS = (("Mask", "1 on a line, 0 elsewhere"), ("Level", "Value of the field on the nearest line"))


def group() -> bpy.types.NodeTree:
    """The file's node group, built if there is none."""
    return next((tree for tree in bpy.data.node_groups if _TAG in tree), None) or _build()


def is_stripes(node: bpy.types.Node) -> bool:
    return node.type == "GROUP" and node.node_tree is not None and _TAG in node.node_tree


def _build() -> bpy.types.NodeTree:
    tree = bpy.data.node_groups.new(NAME, "ShaderNodeTree")
    tree[_TAG] = True
    for name, default, lowest, highest, description in _INPUTS:
        socket = _new_socket(tree, name, "INPUT", description)
        socket.default_value, socket.min_value, socket.max_value = default, lowest, highest
    for name, description in _OUTPUTS:
        _new_socket(tree, name, "OUTPUT", description)
    mask, level = _formula(tree)
    outputs = tree.nodes.new("NodeGroupOutput")
    outputs.location = (1900, 0)
    tree.links.new(mask, outputs.inputs["Mask"])
    tree.links.new(level, outputs.inputs["Level"])
    return tree


def _formula(tree: bpy.types.NodeTree) -> tuple[bpy.types.NodeSocket, bpy.types.NodeSocket]:
    """Mask and level. Where the field is NaN `inside` is 0, since no comparison with it holds, and all else is finite
    since clamping gives a number."""
    field = tree.nodes.new("ShaderNodeAttribute")
    field.attribute_name, field.location = FIELD, (-200, 200)
    given = tree.nodes.new("NodeGroupInput")
    given.location = (-200, -100)
    low, high, count, phase, width, softness = (given.outputs[name] for name, *_ in _INPUTS)
    maths = _Maths(tree)
    extent = maths("SUBTRACT", high, low)
    place = maths("DIVIDE", maths("SUBTRACT", field.outputs["Fac"], low), extent)
    inside = maths("COMPARE", place, 0.5, 0.5 - _HAIR)
    steps = maths("SUBTRACT", maths("MULTIPLY", maths.clamp(place), count), phase)
    center = maths("ADD", maths("FLOOR", steps), 0.5)
    line = maths("DIVIDE", maths("ADD", center, phase), count)  # its place in the window
    drawn = maths("MULTIPLY", inside, maths("COMPARE", line, 0.5, 0.5 - _HAIR))
    distance = maths("ABSOLUTE", maths("SUBTRACT", steps, center))
    margin = maths("SUBTRACT", maths("MULTIPLY", width, 0.5), distance)
    edge = maths.clamp(maths("ADD", maths("DIVIDE", margin, maths("MAXIMUM", softness, 1e-6)), 0.5))
    return maths("MULTIPLY", drawn, edge), maths("ADD", low, maths("MULTIPLY", line, extent))


class _Maths:
    """Adds nodes for one operation after the other, and gives their outputs."""

    def __init__(self, tree: bpy.types.NodeTree) -> None:
        self._tree = tree
        self._nodes = 0

    def __call__(self, operation: str, *arguments: bpy.types.NodeSocket | float) -> bpy.types.NodeSocket:
        node = self._new("ShaderNodeMath")
        node.operation = operation
        return self._fill(node, arguments)

    def clamp(self, value: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
        """Between 0 and 1."""
        return self._fill(self._new("ShaderNodeClamp"), (value, 0.0, 1.0))

    def _new(self, kind: str) -> bpy.types.Node:
        node = self._tree.nodes.new(kind)
        node.hide = True
        node.location = (170 * (self._nodes % 10), 200 - 60 * self._nodes)
        self._nodes += 1
        return node

    def _fill(self, node: bpy.types.Node, arguments) -> bpy.types.NodeSocket:
        for socket, argument in zip(node.inputs, arguments):
            if isinstance(argument, bpy.types.NodeSocket):
                self._tree.links.new(argument, socket)
            else:
                socket.default_value = argument
        return node.outputs[0]


def _new_socket(tree: bpy.types.NodeTree, name: str, in_out: str, description: str):
    if bpy.app.version >= (4, 0, 0):
        return tree.interface.new_socket(name, description=description, in_out=in_out, socket_type="NodeSocketFloat")
    socket = (tree.inputs if in_out == "INPUT" else tree.outputs).new("NodeSocketFloat", name)
    socket.description = description
    return socket
