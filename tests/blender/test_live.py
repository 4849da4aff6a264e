# SPDX-License-Identifier: GPL-3.0-or-later
"""Live: field, colours and lines follow what they depend on. Without a window no timer runs, so tests call it."""

from importlib import import_module

import bpy
import numpy as np
import pytest
from following import assert_current, set_delay, settle, weights
from scene import colors_of, field_of, library_mesh, link, paint, painted_grid, select


def test_painting_is_followed(live, surface, grid_live):
    before = field_of(grid_live), colors_of(grid_live)
    grid_live.vertex_groups["left"].add([30, 31, 32], 1.0, "REPLACE")
    settle(live)
    assert_current(surface, grid_live)
    assert not np.array_equal(field_of(grid_live), before[0])
    assert not np.array_equal(colors_of(grid_live), before[1])


def test_levels_that_cannot_be_had_do_not_hold_the_field_back(live, surface, grid_live):
    grid_live.dirichlet.preview = True
    grid_live.dirichlet.levels_mode, grid_live.dirichlet.levels_list = "LIST", "one"
    grid_live.vertex_groups["left"].add([30, 31, 32], 1.0, "REPLACE")
    settle(live)
    assert_current(surface, grid_live)
    assert "'one', is not a number" in grid_live.dirichlet.results.problem
    assert live.preview_of(grid_live) is None
    grid_live.dirichlet.levels_list = "0.5"
    settle(live)
    assert grid_live.dirichlet.results.problem == ""
    assert live.preview_of(grid_live).lines.levels.tolist() == [0.5]


def test_what_holds_lines_back_is_translated_where_it_is_written_and_not_in_another_thread(live, surface, monkeypatch):
    follower = import_module(live.__name__.removesuffix("live") + "follower")
    monkeypatch.setattr(follower, "told", None)

    class Refused:
        def compute(self, values, most):
            raise surface.InputError("the window from 1 to 0 is empty")

    assert follower._Work(None, None, {0: Refused()}, None).compute()[2] == "the window from 1 to 0 is empty"


@pytest.mark.parametrize(
    "change",
    [
        lambda patches: setattr(patches[1], "value", 3.0),
        lambda patches: setattr(patches[2], "enabled", False),
        lambda patches: setattr(patches[2], "group", "spare"),
    ],
    ids=["value", "enabled", "group"],
)
def test_list_of_patches_is_followed(live, surface, grid_live, change):
    paint(grid_live, "middle", [40], 0.9)
    grid_live.vertex_groups.new(name="spare").add([43], 1.0, "REPLACE")
    settle(live)
    before = field_of(grid_live)
    change(grid_live.dirichlet.patches)
    settle(live)
    assert_current(surface, grid_live)
    assert not np.array_equal(field_of(grid_live), before)


def test_rows_taken_out_or_moved_are_followed(live, surface, grid_live):
    paint(grid_live, "middle", [40], 0.9)
    settle(live)
    assert bpy.ops.dirichlet.patch_remove.poll()
    grid_live.dirichlet.active_patch = 2
    bpy.ops.dirichlet.patch_remove()
    live.flush()
    assert_current(surface, grid_live)
    grid_live.dirichlet.overlap = "first"
    grid_live.vertex_groups["right"].add([0], 1.0, "REPLACE")
    settle(live)
    assert field_of(grid_live)[0] == 0
    grid_live.dirichlet.active_patch = 1
    bpy.ops.dirichlet.patch_move(direction="UP")
    live.flush()
    assert field_of(grid_live)[0] == 1


def test_removed_group_is_said(live, grid_live):
    grid_live.vertex_groups.active_index = 0
    bpy.ops.object.vertex_group_remove()
    settle(live)
    assert "no vertex group 'left'" in grid_live.dirichlet.results.problem


def test_nothing_follows_while_live_is_off(live, grid_live):
    grid_live.dirichlet.live = False
    before = field_of(grid_live)
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    grid_live.dirichlet.patches[0].value = 5
    settle(live)
    assert np.array_equal(field_of(grid_live), before)


def test_evaluating_a_change_is_enough(live, surface, grid_live):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    assert_current(surface, grid_live)
    evaluated = grid_live.evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert np.array_equal(field_of(evaluated), field_of(grid_live))


def test_nothing_is_read_under_a_moving_brush(live, surface, grid_live, monkeypatch):
    monkeypatch.setattr(live, "_brush_may_move", lambda: True)
    set_delay(live, monkeypatch, 1e9)
    before = field_of(grid_live)
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    assert live._tick() is not None
    assert np.array_equal(field_of(grid_live), before)
    set_delay(live, monkeypatch, 0.0)  # the brush has rested long enough
    assert live._tick() is None
    assert_current(surface, grid_live)


def test_a_value_is_followed_in_the_evaluation_that_it_causes(live, surface, grid_live, monkeypatch):
    monkeypatch.setattr(live, "_brush_may_move", lambda: True)
    set_delay(live, monkeypatch, 1e9)
    grid_live.dirichlet.patches[1].value = 2.5
    bpy.context.view_layer.update()  # which tells of object and mesh, as for a stroke
    assert_current(surface, grid_live)
    assert not live.is_pending(grid_live)


def test_a_value_that_is_dragged_on_a_large_mesh_is_waited_for(live, surface, grid_live, monkeypatch):
    monkeypatch.setattr(live, "_brush_may_move", lambda: True)
    monkeypatch.setattr(live, "_INLINE", len(grid_live.data.vertices) - 1)
    set_delay(live, monkeypatch, 1e9)
    before = field_of(grid_live)
    grid_live.dirichlet.patches[1].value = 2.5
    bpy.context.view_layer.update()
    assert np.array_equal(field_of(grid_live), before)
    set_delay(live, monkeypatch, 0.0)
    assert live._tick() is None
    assert_current(surface, grid_live)


def test_own_writes_are_not_followed(live, grid_live, monkeypatch):
    begun = []
    begin = live.Follower.begin

    def counted(self, obj, **how):
        begun.append(self.due())
        begin(self, obj, **how)

    monkeypatch.setattr(live.Follower, "begin", counted)
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    settle(live)
    assert any(begun)
    begun.clear()
    for _ in range(3):
        bpy.context.view_layer.update()
        live._tick()
    assert not any(begun)


def test_undo_and_redo_are_followed(live, surface, grid_live):
    for vertex in (30, 31, 32):
        grid_live.vertex_groups["left"].add([vertex], 1.0, "REPLACE")
        bpy.ops.ed.undo_push(message=f"stroke over {vertex}")
        settle(live)
    for step in (bpy.ops.ed.undo, bpy.ops.ed.undo, bpy.ops.ed.redo):
        step()
        settle(live)
        assert_current(surface, bpy.data.objects["Grid"])
    assert sorted(set(weights(bpy.data.objects["Grid"], "left")) & {30, 31, 32}) == [30, 31]


def test_attributes_that_undo_took_away_come_back(live, surface):
    obj = painted_grid()
    bpy.ops.ed.undo_push(message="painted")
    obj.dirichlet.live = True
    bpy.ops.ed.undo_push(message="live")
    settle(live)
    assert "dirichlet_field" in obj.data.attributes
    obj.location.x = 1
    bpy.ops.ed.undo_push(message="moved")
    bpy.ops.ed.undo()
    settle(live)
    assert_current(surface, bpy.data.objects["Grid"])


def test_reloaded_file_goes_on_following(live, surface, grid_live, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "live.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "live.blend"))
    obj = bpy.data.objects["Grid"]
    obj.vertex_groups["left"].add([30], 1.0, "REPLACE")
    settle(live)
    assert_current(surface, obj)


def test_renamed_object_and_mesh_go_on_following(live, surface, grid_live):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    grid_live.name = grid_live.data.name = "Another"
    live.flush()
    assert_current(surface, grid_live)
    grid_live.vertex_groups["left"].add([33], 1.0, "REPLACE")
    settle(live)
    assert_current(surface, grid_live)


def test_object_deleted_while_something_is_pending(live, grid_live):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    bpy.data.objects.remove(grid_live)
    settle(live)
    assert live._tick() is None


def test_edited_mesh_is_solved_as_it_is(live, surface, grid_live):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    grid_live.dirichlet.patches[0].value = -1
    settle(live)
    bpy.ops.object.mode_set(mode="OBJECT")
    settle(live)
    assert len(grid_live.data.vertices) > 84
    assert_current(surface, grid_live)


def test_what_cannot_be_solved_is_said_and_leaves_the_field(live, surface, grid_live):
    before = field_of(grid_live)
    grid_live.vertex_groups["left"].add([11], 1.0, "REPLACE")
    settle(live)
    assert "'left' with value 0 and in 'right' with value 1" in grid_live.dirichlet.results.problem
    assert np.array_equal(field_of(grid_live), before)
    grid_live.vertex_groups["left"].remove([11])
    grid_live.vertex_groups["left"].add([13], 1.0, "REPLACE")
    settle(live)
    assert grid_live.dirichlet.results.problem == ""
    assert_current(surface, grid_live)


def test_edited_ramp_recolors_without_a_solve(live, addon):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    field = field_of(obj)
    bpy.context.view_layer.update()
    ramp = obj.material_slots[0].material.node_tree.nodes["Dirichlet Ramp"].color_ramp
    ramp.elements[0].color = (0.25, 0.5, 0.75, 1)
    settle(live)
    assert np.allclose(colors_of(obj)[0], (0.25, 0.5, 0.75, 1), atol=1e-6)
    assert np.array_equal(field_of(obj), field)
    assert "solve" not in live.timings(obj)


def test_preview_follows_the_window_without_a_solve(live, surface, grid_live, monkeypatch):
    settings = grid_live.dirichlet
    settings.preview = True
    settle(live)
    whole = live.preview_of(grid_live)
    monkeypatch.setattr(live, "_brush_may_move", lambda: True)
    settings.window_low, settings.window_high, settings.count = 0.25, 0.5, 4
    bpy.context.view_layer.update()
    part = live.preview_of(grid_live)
    expected = surface.isolines(
        library_mesh(surface, grid_live), field_of(grid_live), surface.even_levels(0.25, 0.5, 4)
    )
    assert np.array_equal(part.lines.points, expected.points)
    assert part.colors.shape == (4, 4)
    assert part.version != whole.version
    assert "solve" not in live.timings(grid_live)


def test_preview_without_live_shows_the_field_that_is_there(live, grid_live):
    settings = grid_live.dirichlet
    settings.live, settings.preview = False, True
    settle(live)
    assert len(live.preview_of(grid_live).lines.levels) == settings.count
    settings.preview = False
    settle(live)
    assert live.preview_of(grid_live) is None


def test_curve_object_follows_while_live(live, surface, grid_live):
    bpy.ops.dirichlet.make_isolines()
    curve = grid_live.dirichlet.isolines.data
    grid_live.vertex_groups["left"].add([30, 31], 1.0, "REPLACE")
    grid_live.dirichlet.count = 5
    settle(live)
    lines = surface.isolines(library_mesh(surface, grid_live), field_of(grid_live), surface.even_levels(0, 1, 5))
    assert len(curve.splines) == len(lines)
    assert list(curve["dirichlet_level"]) == lines.levels[lines.level].tolist()


def test_animated_value_gives_every_frame_its_field(live, surface, grid_live):
    patch = grid_live.dirichlet.patches[1]
    for frame, value in ((1, 1.0), (11, 3.0)):
        patch.value = value
        patch.keyframe_insert("value", frame=frame)
    highest = []
    for frame in (1, 6, 11):
        bpy.context.scene.frame_set(frame)
        assert_current(surface, grid_live)
        highest.append(field_of(grid_live).max())
    assert highest[0] == 1
    assert 1 < highest[1] < highest[2] == 3


def test_linked_object_is_left_alone(live, grid_live, tmp_path):
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.objects = ["Grid"]
    bpy.context.collection.objects.link(wanted.objects[0])
    bpy.context.view_layer.update()
    live.changed(wanted.objects[0], live.Change.FIELD)
    assert not live.is_pending(wanted.objects[0])


def test_selection_made_in_edit_mode_is_no_change_of_the_field(live, grid_live):
    before = field_of(grid_live)
    select(grid_live, [3, 4])
    settle(live)
    assert np.array_equal(field_of(grid_live), before)


def test_color_attribute_that_somebody_paints_on_stays_active(live, grid_live):
    colors = grid_live.data.color_attributes
    colors.active_color = colors.new("mine", "FLOAT_COLOR", "POINT")
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    settle(live)
    assert colors.active_color.name == "mine"
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert colors.active_color.name == "dirichlet_color"


def test_material_that_the_user_put_there_stays(live, surface, grid_live):
    grid_live.material_slots[0].material = bpy.data.materials.new("clay")
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    settle(live)
    assert grid_live.material_slots[0].material.name == "clay"
    assert_current(surface, grid_live)


def test_of_objects_on_one_mesh_the_active_one_is_live(live, surface, grid_live):
    other = link(grid_live.data, "Other")
    patch = other.dirichlet.patches.add()
    patch.group, patch.value = "left", 5.0
    other.dirichlet.live = True
    settle(live)
    assert (field_of(other) == 5).all()
    grid_live.dirichlet.patches[1].value = 2.0
    settle(live)
    assert (field_of(other) == 5).all()
    assert "'Other' is live on the same mesh" in grid_live.dirichlet.results.problem
    bpy.context.view_layer.objects.active = grid_live
    grid_live.dirichlet.patches[1].value = 3.0
    settle(live)
    assert_current(surface, grid_live)


def test_frame_without_animation_solves_nothing(live, grid_live, monkeypatch):
    begun = []
    monkeypatch.setattr(live.Follower, "begin", lambda self, obj, **how: begun.append(obj.name))
    for frame in (2, 3):
        bpy.context.scene.frame_set(frame)
    assert begun == []


def test_preview_of_a_field_that_is_gone_is_gone(live, grid_live):
    grid_live.dirichlet.live, grid_live.dirichlet.preview = False, True
    settle(live)
    assert live.preview_of(grid_live)
    grid_live.data.attributes.remove(grid_live.data.attributes["dirichlet_field"])
    grid_live.dirichlet.count = 5
    settle(live)
    assert live.preview_of(grid_live) is None


def test_deleted_object_that_a_result_remembers_is_not_solved(live, grid_live):
    bpy.ops.dirichlet.make_isolines()
    before = field_of(grid_live)
    bpy.context.collection.objects.unlink(grid_live)
    grid_live.dirichlet.patches[1].value = 3.0
    settle(live)
    assert np.array_equal(field_of(grid_live), before)


def test_more_levels_than_can_be_followed_are_refused_in_a_sentence(live, grid_live):
    grid_live.dirichlet.preview = True
    grid_live.dirichlet.count = 100_000
    settle(live)
    assert "100000 levels are too many to follow" in grid_live.dirichlet.results.problem
    grid_live.dirichlet.count = 10
    settle(live)
    assert grid_live.dirichlet.results.problem == ""


def test_lines_are_those_of_the_scene_that_shows_the_object(live, grid_live):
    """Another scene evaluates, too; it knows nothing of the object's shape."""
    bpy.ops.dirichlet.make_isolines()
    grid_live.shape_key_add(name="Basis")
    key = grid_live.shape_key_add(name="Up")
    for point in key.data:
        point.co.z = 5.0
    key.value = 1.0
    settle(live)
    other = bpy.data.scenes.new("Other")
    grid_live.dirichlet.count = 4
    other.view_layers[0].update()
    other.frame_set(2)
    settle(live)
    heights = {point.co.z for spline in grid_live.dirichlet.isolines.data.splines for point in spline.points}
    assert heights == {5.0}
