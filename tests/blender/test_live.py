# SPDX-License-Identifier: GPL-3.0-or-later
"""Live: field, colours and lines follow what they depend on. Without a window no timer runs, so tests call it."""

import importlib
import time

import bpy
import numpy as np
import pytest
from scene import colors_of, field_of, library_mesh, paint, painted_grid, select


@pytest.fixture
def live(addon):
    return importlib.import_module(f"{addon.__name__}.blender.live")


@pytest.fixture
def grid_live(live):
    """A painted grid, solved, with Live on and nothing pending."""
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.live = True
    settle(live)
    return obj


def settle(live):
    bpy.context.view_layer.update()
    live.flush()


def set_delay(live, monkeypatch, seconds):
    monkeypatch.setattr(live.preferences, "DEFAULTS", live.preferences.Preferences(live_delay=seconds))


def weights(obj, group):
    index = obj.vertex_groups[group].index
    found = {v.index: g.weight for v in obj.data.vertices for g in v.groups if g.group == index}
    return [vertex for vertex, weight in found.items() if weight >= 0.5]


def fresh_field(surface, obj):
    """Solved by the library alone, from the weights as they are."""
    painted = {}
    for patch in obj.dirichlet.patches:
        if patch.enabled:
            painted |= dict.fromkeys(weights(obj, patch.group), patch.value)
    values = surface.solve(library_mesh(surface, obj), list(painted), list(painted.values())).values
    return values.astype(np.float32)


def assert_current(surface, obj):
    assert np.array_equal(field_of(obj), fresh_field(surface, obj))


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


def test_own_writes_are_not_followed(live, grid_live):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    settle(live)
    for _ in range(3):
        bpy.context.view_layer.update()
        assert not live.is_pending(grid_live)


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


class TestThread:
    """Meshes large enough to be computed in a thread, whose result the timer fetches."""

    @pytest.fixture(autouse=True)
    def _every_mesh_is_large(self, live, monkeypatch):
        monkeypatch.setattr(live, "_needs_thread", lambda obj, what: True)
        set_delay(live, monkeypatch, 0.0)

    def test_result_is_fetched(self, live, surface, grid_live):
        grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        run_timer(live)
        assert_current(surface, grid_live)

    def test_outdated_result_is_dropped_and_the_newest_wins(self, addon, live, surface, grid_live, monkeypatch):
        session = importlib.import_module(f"{addon.__name__}.blender.mesh.sessions").Session
        paint_now, painted = session.paint, []

        def slow_paint(self, painting, options):
            painted.append(len(painting.vertices))
            time.sleep(0.05)
            return paint_now(self, painting, options)

        monkeypatch.setattr(session, "paint", slow_paint)
        before = field_of(grid_live)
        grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        live._tick()
        while not painted:
            time.sleep(0.001)
        grid_live.vertex_groups["left"].add([31], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        while len(painted) < 2:
            assert np.array_equal(field_of(grid_live), before)
            live._tick()
        run_timer(live)
        assert painted == [15, 16]
        assert_current(surface, grid_live)

    def test_disabled_while_computing(self, live, addon, grid_live):
        grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        live._tick()
        addon.unregister()
        try:
            assert not live._followers
            assert live._threads is None
        finally:
            addon.register()

    def test_object_deleted_while_computing(self, live, grid_live):
        grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        live._tick()
        bpy.data.objects.remove(grid_live)
        run_timer(live)
        assert not live._followers


def run_timer(live):
    deadline = time.monotonic() + 30
    while live._tick() is not None:
        assert time.monotonic() < deadline, "the timer never came to rest"
        time.sleep(0.001)


def test_selection_made_in_edit_mode_is_no_change_of_the_field(live, grid_live):
    before = field_of(grid_live)
    select(grid_live, [3, 4])
    settle(live)
    assert np.array_equal(field_of(grid_live), before)
