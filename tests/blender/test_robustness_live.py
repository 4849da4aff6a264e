# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens to an object while its field is being computed, or while the add-on is away."""

import importlib
import threading

import bpy
import pytest
from following import assert_current, set_delay, settle
from scene import painted_grid


@pytest.fixture
def gate(live, addon, monkeypatch):
    """Every mesh is large, and its field is computed in a thread, which waits here until the gate is opened."""
    monkeypatch.setattr(live, "_needs_thread", lambda obj, follower: True)
    monkeypatch.setattr(live, "_PATIENCE", 0.0)
    set_delay(live, monkeypatch, 0.0)
    session = importlib.import_module(f"{addon.__name__}.blender.mesh.sessions").Session
    paint_now, opened = session.paint, threading.Event()

    def paint_later(self, *arguments):
        opened.wait(10)
        return paint_now(self, *arguments)

    monkeypatch.setattr(session, "paint", paint_later)
    yield opened
    opened.set()


def begin(live, obj):
    """A stroke, whose field is then being computed."""
    obj.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.ops.ed.undo_push(message="stroke")
    bpy.context.view_layer.update()
    live._tick()
    assert live.is_pending(obj)


def finish(live, gate):
    gate.set()
    while live._tick() is not None:
        pass


@pytest.fixture
def computing(live, gate):
    """A painted grid whose field was there, undo steps and all, and is being computed anew."""
    gate.set()
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.live = True
    settle(live)
    bpy.ops.ed.undo_push(message="live")
    gate.clear()
    begin(live, obj)
    return obj


def test_undo_while_computing(live, surface, gate, computing):
    bpy.ops.ed.undo()
    finish(live, gate)
    obj = bpy.data.objects["Grid"]
    assert 30 not in [v.index for v in obj.data.vertices if any(g.group == 0 and g.weight > 0 for g in v.groups)]
    assert_current(surface, obj)
    bpy.ops.ed.redo()
    bpy.context.view_layer.update()
    finish(live, gate)
    assert_current(surface, bpy.data.objects["Grid"])


def test_renamed_while_computing(live, surface, gate, computing):
    computing.name = computing.data.name = computing.vertex_groups["left"].name = "Renamed"
    computing.dirichlet.patches[0].group = "Renamed"
    finish(live, gate)
    assert_current(surface, computing)


def test_group_deleted_while_computing(live, gate, computing):
    computing.vertex_groups.remove(computing.vertex_groups["left"])
    computing.data.update()
    bpy.context.view_layer.update()
    finish(live, gate)
    assert "object 'Grid' has no vertex group 'left'" in computing.dirichlet.results.problem


def test_edit_mode_while_computing(live, surface, gate, computing):
    bpy.ops.object.mode_set(mode="EDIT")
    finish(live, gate)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    finish(live, gate)
    assert_current(surface, computing)


def test_another_file_opened_while_computing(live, gate, computing, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "other.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "other.blend"))
    finish(live, gate)
    obj = bpy.data.objects["Grid"]
    assert obj.dirichlet.results.problem == ""


@pytest.mark.parametrize("hide", ["excluded", "disabled"])
def test_hidden_while_computing(live, surface, gate, computing, hide):
    if hide == "disabled":
        computing.hide_viewport = True
    else:
        collection = bpy.data.collections.new("Away")
        bpy.context.scene.collection.children.link(collection)
        collection.objects.link(computing)
        bpy.context.scene.collection.objects.unlink(computing)
        bpy.context.view_layer.layer_collection.children["Away"].exclude = True
    finish(live, gate)
    assert_current(surface, computing)


def test_disabled_while_live_then_enabled_again(live, surface, addon, grid_live):
    addon.unregister()
    try:
        grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="painted without the add-on")
    finally:
        addon.register()
    assert grid_live.dirichlet.live
    grid_live.vertex_groups["left"].add([31], 1.0, "REPLACE")
    settle(live)
    assert_current(surface, grid_live)


def test_enabled_again_it_catches_up_and_previews_by_itself(live, surface, addon, grid_live):
    handlers = importlib.import_module(f"{addon.__name__}.ui.handlers")
    grid_live.dirichlet.preview = True
    settle(live)
    addon.unregister()
    try:
        assert not bpy.app.timers.is_registered(handlers._enabled)
        grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
        bpy.context.view_layer.update()
    finally:
        addon.register()
    assert bpy.app.timers.is_registered(handlers._enabled)
    handlers._enabled()  # which a window's timer would
    settle(live)
    assert live.preview_of(grid_live)
    assert_current(surface, grid_live)


def test_previews_are_there_again_after_loading_and_undo(live, grid_live, tmp_path):
    grid_live.dirichlet.live, grid_live.dirichlet.preview = False, True
    path = str(tmp_path / "preview.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    settle(live)
    assert live.preview_of(bpy.data.objects["Grid"])
    bpy.ops.ed.undo_push(message="loaded")
    bpy.data.objects.remove(bpy.data.objects["Grid"])
    settle(live)
    bpy.ops.ed.undo_push(message="deleted")
    bpy.ops.ed.undo()
    settle(live)
    assert live.preview_of(bpy.data.objects["Grid"])
