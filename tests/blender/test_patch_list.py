# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of patches: order, copies, and what it says about every patch."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import colors_of, field_of, grid, library_mesh, paint, painted_grid, painted_sphere, select


def names(obj):
    return [patch.group for patch in obj.dirichlet.patches]


def weights(obj, group):
    index = obj.vertex_groups[group].index
    return {v.index: g.weight for v in obj.data.vertices for g in v.groups if g.group == index}


def checked(obj):
    """{group: (vertices, problem)}"""
    assert bpy.ops.dirichlet.check_patches() == {"FINISHED"}
    return {patch.group: (patch.vertices, patch.problem) for patch in obj.dirichlet.patches}


def three_patches():
    obj = grid()
    for k, name in enumerate("abc"):
        paint(obj, name, [5 * k], value=k)
    return obj


@pytest.mark.parametrize(
    ("row", "direction", "order"), [(0, "DOWN", "bac"), (1, "DOWN", "acb"), (1, "UP", "bac"), (2, "UP", "acb")]
)
def test_a_moved_patch_stays_selected(row, direction, order):
    obj = three_patches()
    obj.dirichlet.active_patch = row
    bpy.ops.dirichlet.patch_move(direction=direction)
    assert names(obj) == list(order)
    assert names(obj)[obj.dirichlet.active_patch] == "abc"[row]
    assert sorted((patch.group, patch.value) for patch in obj.dirichlet.patches) == [("a", 0), ("b", 1), ("c", 2)]


@pytest.mark.parametrize(("row", "direction"), [(0, "UP"), (2, "DOWN")])
def test_at_the_end_of_the_list_nothing_moves(row, direction):
    obj = three_patches()
    obj.dirichlet.active_patch = row
    assert bpy.ops.dirichlet.patch_move(direction=direction) == {"CANCELLED"}
    assert (names(obj), obj.dirichlet.active_patch) == (list("abc"), row)


@pytest.mark.parametrize("row", [0, 1, 2])
def test_removing_a_patch_leaves_a_row_selected(row):
    obj = three_patches()
    obj.dirichlet.active_patch = row
    for left in (2, 1, 0):
        bpy.ops.dirichlet.patch_remove()
        assert len(obj.dirichlet.patches) == left
        assert 0 <= obj.dirichlet.active_patch < max(left, 1)


@pytest.mark.parametrize("mode", ["OBJECT", "WEIGHT_PAINT", "VERTEX_PAINT"])
def test_a_copy_has_the_weights_and_settings_under_the_next_free_name(mode):
    obj = three_patches()
    paint(obj, "b", [6], weight=0.25)
    original = obj.dirichlet.patches[1]
    original.value, original.enabled, original.weights_as_values = 4.5, False, True
    obj.dirichlet.active_patch = 1
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.dirichlet.patch_duplicate()
    assert names(obj) == ["a", "b", "b.001", "c"]
    assert obj.dirichlet.active_patch == 2
    copy = obj.dirichlet.patches[2]
    assert (copy.value, copy.enabled, copy.weights_as_values) == (4.5, False, True)
    assert weights(obj, "b.001") == weights(obj, "b") == {5: 1.0, 6: 0.25}
    paint(obj, "b.001", [7])
    assert 7 not in weights(obj, "b")
    bpy.ops.dirichlet.patch_duplicate()
    assert names(obj) == ["a", "b", "b.001", "b.002", "c"]


def test_duplicating_is_one_undo_step():
    three_patches().dirichlet.active_patch = 1
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.dirichlet.patch_duplicate("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    obj = bpy.data.objects["Grid"]
    assert names(obj) == list("abc")
    assert [group.name for group in obj.vertex_groups] == list("abc")
    bpy.ops.ed.redo()
    assert names(bpy.data.objects["Grid"]) == ["a", "b", "b.001", "c"]


def test_a_patch_whose_group_is_gone_is_not_duplicated():
    obj = three_patches()
    obj.vertex_groups.remove(obj.vertex_groups["a"])
    obj.dirichlet.active_patch = 0
    assert_refused(bpy.ops.dirichlet.patch_duplicate, obj, "no vertex group 'a'")


def disc(obj):
    paint(obj, "p", [13, 14, 25, 26])


def nothing(obj):
    paint(obj, "p", [13, 14], weight=0.1)


def two_pieces(obj):
    paint(obj, "p", [0, 1, 12, 13, 30, 31, 42, 43])


def ring(obj):
    paint(obj, "p", [x + 12 * y for y in range(1, 5) for x in range(1, 5) if not (x in (2, 3) and y in (2, 3))])
    paint(obj, "p", [x + 12 * y for y in (0, 5) for x in range(6)] + [x + 12 * y for y in range(6) for x in (0, 5)])


def single_vertex(obj):
    paint(obj, "p", [30])


def closed_line(obj):
    paint(obj, "p", [13, 14, 15, 27, 39, 38, 37, 25])


def hourglass(obj):
    paint(obj, "p", [13, 14, 25, 26, 27, 38, 39])


@pytest.mark.parametrize(
    ("painted", "count", "problem"),
    [
        (disc, 4, ""),
        (closed_line, 8, ""),
        (nothing, 0, "Empty"),
        (two_pieces, 8, "Not connected: 2 pieces"),
        (ring, 32, "Not a disc: 2 borders"),
        (single_vertex, 1, "Not a disc: it covers no face"),
        (hourglass, 7, "Not a disc: faces meet in a single vertex"),
    ],
)
def test_the_list_says_what_keeps_a_patch_from_being_a_disc(painted, count, problem):
    obj = grid()
    painted(obj)
    paint(obj, "other", [70, 71, 82, 83], 1.0)
    facts = checked(obj)
    assert facts["p"][0] == count
    assert facts["p"][1].startswith(problem) if problem else facts["p"][1] == ""
    assert facts["other"] == (4, "")


def test_a_whole_closed_surface_has_no_border():
    obj = painted_sphere(2)
    paint(obj, "all", range(len(obj.data.vertices)), 0.5)
    assert checked(obj)["all"][1] == "Overlaps 'bottom', 'top'; Not a disc: it has no border"


def test_overlapping_patches_name_each_other_and_rows_that_are_off_take_no_part():
    obj = three_patches()
    for name in "abc":
        paint(obj, name, [40, 41, 52, 53])
    obj.dirichlet.patches[1].enabled = False
    facts = checked(obj)
    assert facts["a"][1].startswith("Overlaps 'c'")
    assert facts["c"][1].startswith("Overlaps 'a'")
    assert facts["b"] == (0, "")


def test_a_group_that_is_listed_twice_is_called_that():
    obj = three_patches()
    paint(obj, "a", [40, 41, 52, 53], weight=0.25)
    twin = obj.dirichlet.patches.add()
    twin.group, twin.weights_as_values = "a", True
    paint(obj, "b", [41])
    bpy.ops.dirichlet.check_patches()
    first, second, _, last = sorted(obj.dirichlet.patches, key=lambda patch: patch.group)
    assert (first.vertices, second.vertices) == (1, 5)
    assert first.problem.startswith("The vertex group is in the list twice; Not a disc")
    assert second.problem.startswith("The vertex group is in the list twice; Overlaps 'b'; Not connected")
    assert "twice" not in last.problem


def problems(obj):
    return {patch.group: patch.problem for patch in obj.dirichlet.patches}


def test_a_copy_overlaps_its_original_at_once_and_no_more_when_that_is_removed():
    obj = grid()
    disc(obj)
    bpy.ops.dirichlet.patch_duplicate()
    assert problems(obj) == {"p": "Overlaps 'p.001'", "p.001": "Overlaps 'p'"}
    obj.dirichlet.active_patch = 0
    bpy.ops.dirichlet.patch_remove()
    assert problems(obj) == {"p.001": ""}


def from_borders(obj):
    bpy.ops.dirichlet.patches_from_borders()


def from_attribute(obj):
    spots = obj.data.attributes.new("spots", "BOOLEAN", "POINT")
    spots.data.foreach_set("value", [vertex in (13, 14, 25, 26) for vertex in range(len(obj.data.vertices))])
    bpy.ops.dirichlet.patches_from_attribute(attribute="spots")


def from_group(obj):
    obj.vertex_groups.new(name="group").add([13, 14, 25, 26], 1.0, "REPLACE")
    bpy.ops.dirichlet.patch_add_group(group="group")


def by_disc(obj):
    bpy.ops.dirichlet.add_patch_disc(location=(1, 1, 0), radius=1.5)


def from_selected(obj):
    select(obj, [13, 14, 25, 26])
    bpy.ops.dirichlet.patch_add_selected()


ADDING = [from_borders, from_attribute, from_group, from_selected, by_disc]


@pytest.mark.parametrize("add", ADDING)
def test_a_patch_that_is_added_over_another_is_told_at_once(add):
    obj = grid()
    paint(obj, "p", [0, 1, 12, 13])
    add(obj)
    added = obj.dirichlet.patches[-1]
    assert added.vertices >= 4
    assert problems(obj) == {"p": f"Overlaps '{added.group}'", added.group: "Overlaps 'p'"}


def test_a_new_empty_patch_is_not_called_empty_before_it_could_be_painted():
    obj = grid()
    bpy.ops.dirichlet.patch_add_group()
    assert problems(obj) == {"Patch": ""}


def test_the_list_of_a_large_mesh_changes_without_reading_it(module, monkeypatch):
    obj = grid()
    monkeypatch.setattr(module("paint.patches"), "QUICK", len(obj.data.vertices) - 1)
    disc(obj)
    bpy.ops.dirichlet.patch_duplicate()
    assert problems(obj) == {"p": "", "p.001": ""}


def test_a_row_that_cannot_be_read_keeps_nobody_from_changing_the_list():
    obj = grid()
    disc(obj)
    obj.dirichlet.patches.add().group = "nobody"
    bpy.ops.dirichlet.patch_duplicate()
    assert names(obj) == ["p", "p.001", "nobody"]


def test_solving_counts_and_checks_the_patches():
    obj = painted_grid()
    paint(obj, "left", [5])
    bpy.ops.dirichlet.solve_field()
    assert [patch.vertices for patch in obj.dirichlet.patches] == [8, 7]
    assert obj.dirichlet.patches[0].problem == "Not connected: 2 pieces"


def test_facts_that_come_late_find_their_rows_in_a_list_that_changed(module, surface):
    """As they do from a thread, for rows removed, moved and added meanwhile."""
    patches = module("paint.patches")
    obj = three_patches()
    painted = [surface.Patch(name, np.arange(k + 1), 0.0) for k, name in enumerate("abc")]
    obj.dirichlet.patches.remove(1)
    obj.dirichlet.patches.move(1, 0)
    paint(obj, "new", [50])
    patches.record_facts(obj, painted, patches.inspect(library_mesh(surface, obj), painted))
    assert [(patch.group, patch.vertices) for patch in obj.dirichlet.patches] == [("c", 3), ("a", 1), ("new", 0)]


def test_the_warning_explains_itself_in_its_tooltip(addon):
    obj = grid()
    single_vertex(obj)
    problem = checked(obj)["p"][1]
    operator = bpy.types.DIRICHLET_OT_check_patches
    assert operator.description(bpy.context, type("Row", (), {"index": 0})).startswith(problem)
    assert operator.description(bpy.context, type("All", (), {"index": -1})) == operator.bl_description
    bpy.context.view_layer.objects.active = None
    assert operator.description(bpy.context, type("Row", (), {"index": 0})) == operator.bl_description


def test_a_group_that_is_gone_is_named_by_the_check():
    obj = three_patches()
    obj.vertex_groups.remove(obj.vertex_groups["b"])
    assert_refused(bpy.ops.dirichlet.check_patches, obj, "no vertex group 'b'")


def test_a_patch_has_the_color_that_its_vertices_have():
    obj = painted_grid()
    obj.dirichlet.patches[0].value, obj.dirichlet.patches[1].value = -2, 3
    paint(obj, "middle", [5, 6, 17, 18], 0.375)
    bpy.ops.dirichlet.solve_field()
    values, colors = field_of(obj), colors_of(obj)
    for patch in obj.dirichlet.patches:
        vertex = np.flatnonzero(values == np.float32(patch.value))[0]
        assert np.allclose(patch.color, colors[vertex, :3], atol=1e-4)
    with pytest.raises(AttributeError):
        obj.dirichlet.patches[0].color = (0, 0, 0)


def test_the_color_is_grey_before_there_is_a_field():
    assert np.allclose([list(patch.color) for patch in three_patches().dirichlet.patches], 0.5)


@pytest.mark.parametrize("name", ["patch_move", "patch_duplicate", "check_patches"])
def test_edit_mode_is_left_first(name):
    three_patches()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="mode first"):
        getattr(bpy.ops.dirichlet, name)()
