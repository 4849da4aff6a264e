# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of patches and its buttons."""

import bpy
import numpy as np
import pytest
from scene import grid, paint, painted_grid, select


def rows(obj):
    return [(patch.group, patch.value) for patch in obj.dirichlet.patches]


def members(obj, name):
    index = obj.vertex_groups[name].index
    return [
        vertex.index for vertex in obj.data.vertices if (index, 1.0) in [(g.group, g.weight) for g in vertex.groups]
    ]


def test_add_from_group_takes_the_active_one_then_those_without_patch():
    obj = grid()
    for name in ("a", "b", "c"):
        obj.vertex_groups.new(name=name)
    obj.vertex_groups.active_index = 1
    for _ in range(3):
        bpy.ops.dirichlet.patch_add_group()
    assert rows(obj) == [("b", 0), ("a", 1), ("c", 2)]
    assert obj.dirichlet.active_patch == 2
    bpy.ops.dirichlet.patch_add_group()  # all are listed: another one begins, and is what is painted next
    assert rows(obj)[3:] == [("Patch", 3)]
    assert obj.vertex_groups.active.name == "Patch"


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_add_from_selected_makes_a_group_of_the_selection(mode):
    obj = grid()
    select(obj, {3, 4, 16})
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.dirichlet.patch_add_selected()
    assert obj.mode == "OBJECT"
    assert members(obj, "Patch") == [3, 4, 16]
    assert rows(obj) == [("Patch", 0)]
    select(obj, {7})
    bpy.ops.dirichlet.patch_add_selected()
    assert rows(obj) == [("Patch", 0), ("Patch.001", 1)]


def test_add_from_selected_in_edit_mode_is_one_undo_step():
    select(grid(), {3})
    bpy.ops.ed.undo_push(message="selected")
    bpy.ops.object.mode_set("EXEC_DEFAULT", True, mode="EDIT")
    bpy.ops.dirichlet.patch_add_selected("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    obj = bpy.data.objects["Grid"]
    assert obj.mode == "EDIT"
    assert rows(obj) == []
    assert not obj.vertex_groups


def test_add_from_selected_stays_in_edit_mode_without_a_selection():
    obj = grid()
    select(obj, ())
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="No vertex of 'Grid' is selected"):
        bpy.ops.dirichlet.patch_add_selected()
    assert obj.mode == "EDIT"


def test_remove_keeps_the_vertex_group():
    obj = painted_grid()
    obj.dirichlet.active_patch = 1
    bpy.ops.dirichlet.patch_remove()
    assert rows(obj) == [("left", 0)]
    assert obj.dirichlet.active_patch == 0
    assert "right" in obj.vertex_groups


def test_paint_goes_to_weight_paint_with_the_group_active():
    obj = painted_grid()
    obj.dirichlet.active_patch = 0
    bpy.ops.dirichlet.patch_paint()
    assert obj.mode == "WEIGHT_PAINT"
    assert obj.vertex_groups.active.name == "left"


def test_paint_says_when_the_group_is_gone():
    obj = painted_grid()
    obj.vertex_groups.clear()
    with pytest.raises(RuntimeError, match="pick one in its row"):
        bpy.ops.dirichlet.patch_paint()
    assert obj.mode == "OBJECT"


def test_spread_gives_enabled_patches_even_values():
    obj = grid()
    for k in range(6):
        paint(obj, f"group {k}", [k], value=9.0)
    obj.dirichlet.patches[2].enabled = False
    bpy.ops.dirichlet.patch_spread_values()
    assert np.allclose([patch.value for patch in obj.dirichlet.patches], [0, 0.25, 9, 0.5, 0.75, 1])


@pytest.mark.parametrize("name", ["patch_remove", "patch_paint", "patch_spread_values"])
def test_empty_list_says_what_to_do(name):
    grid()
    with pytest.raises(RuntimeError, match=r"patch .*first"):
        getattr(bpy.ops.dirichlet, name)()
