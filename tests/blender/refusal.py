# SPDX-License-Identifier: GPL-3.0-or-later
"""What a refusal has to be: one sentence, and nothing changed."""

import bpy
import pytest


def data_counts():
    """How many data-blocks of every kind the file has."""
    kinds = (name for name in dir(bpy.data) if isinstance(getattr(bpy.data, name), bpy.types.bpy_prop_collection))
    return {name: len(getattr(bpy.data, name)) for name in kinds}


def state(obj):
    """Everything that a refused operator must leave as it was."""
    mesh = obj.data
    return {
        "data": data_counts(),
        "attributes": {found.name: _values(found) for found in mesh.attributes if not found.name.startswith(".")},
        "corners": [loop.vertex_index for loop in mesh.loops],
        "groups": [group.name for group in obj.vertex_groups],
        "weights": [[(g.group, repr(g.weight)) for g in vertex.groups] for vertex in mesh.vertices],
        "slots": [(slot.link, slot.material) for slot in obj.material_slots],
        "settings": _properties(obj.dirichlet),
        "mode": obj.mode,
        "children": [child.name for child in obj.children],
        "active color": mesh.color_attributes.active_color_name,
    }


def _values(attribute):
    """As text, since a NaN differs from itself."""
    return [repr(getattr(item, name)) for item in attribute.data for name in ("value", "vector", "color") if
            hasattr(item, name)]  # fmt: skip


def _properties(group):
    values = {}
    for name in set(group.bl_rna.properties.keys()) - {"rna_type"}:
        value = getattr(group, name)
        if isinstance(value, bpy.types.PropertyGroup):
            value = _properties(value)
        elif isinstance(value, bpy.types.bpy_prop_collection):
            value = [_properties(item) for item in value]
        values[name] = value if isinstance(value, dict | list) else repr(value)
    return values


def assert_refused(operator, obj, sentence):
    """One sentence, nothing changed, and one undo goes back over the step before the operator."""
    marker = bpy.context.scene
    marker["step"] = 1
    bpy.ops.ed.undo_push(message="one")
    marker["step"] = 2
    bpy.ops.ed.undo_push(message="two")
    before = state(obj)
    with pytest.raises(RuntimeError, match=sentence) as refusal:
        operator("EXEC_DEFAULT", True)
    assert "Traceback" not in str(refusal.value)
    assert len(str(refusal.value).strip().splitlines()) == 1
    assert state(obj) == before
    bpy.ops.ed.undo()
    assert bpy.context.scene["step"] == 1
