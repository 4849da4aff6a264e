# SPDX-License-Identifier: GPL-3.0-or-later
"""Live on meshes large enough to be computed in a thread, whose result the timer fetches."""

import importlib
import time
from threading import Event

import bpy
import numpy as np
import pytest
from following import assert_current, set_delay, settle
from scene import field_of, painted_grid


@pytest.fixture(autouse=True)
def _every_mesh_is_large(live, monkeypatch):
    monkeypatch.setattr(live, "_needs_thread", lambda obj, follower: True)
    monkeypatch.setattr(live, "_PATIENCE", 0.0)
    set_delay(live, monkeypatch, 0.0)


def test_result_is_fetched(live, surface, grid_live):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    run_timer(live)
    assert_current(surface, grid_live)


@pytest.fixture
def painted(addon, monkeypatch, grid_live):
    """Painting takes its time; how many vertices were painted each time."""
    session = importlib.import_module(f"{addon.__name__}.blender.mesh.sessions").Session
    paint_now, painted = session.paint, []

    def slow_paint(self, painting, *how):
        painted.append(len(painting.vertices))
        time.sleep(0.05)
        return paint_now(self, painting, *how)

    monkeypatch.setattr(session, "paint", slow_paint)
    return painted


def test_outdated_result_is_dropped_and_the_newest_wins(live, surface, grid_live, painted):
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


def test_disabled_while_computing(live, addon, grid_live, painted):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    live._tick()
    addon.unregister()
    try:
        assert not live._followers
        assert not live.threads._running
    finally:
        addon.register()


def test_object_deleted_while_computing(live, grid_live, painted):
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


def test_another_object_in_the_place_of_a_deleted_one_is_not_written(live, grid_live, painted):
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    live._tick()
    ((address, follower),) = live._followers.items()
    other = painted_grid(columns=9, name="Other")
    live._followers[other.as_pointer()] = live._followers.pop(address)
    bpy.data.objects.remove(grid_live)
    follower.held.name, follower.held._address = "Other", other.as_pointer()
    run_timer(live)
    assert "dirichlet_field" not in other.data.attributes


@pytest.mark.parametrize("change", ["edited", "off"])
def test_object_that_changed_while_computing_is_not_written(live, grid_live, painted, change):
    before = field_of(grid_live)
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    bpy.context.view_layer.update()
    live._tick()
    grid_live.dirichlet.live = False
    if change == "edited":
        grid_live.data.clear_geometry()
        grid_live.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    run_timer(live)
    assert grid_live.dirichlet.results.problem == ""
    if change == "off":
        assert np.array_equal(field_of(grid_live), before)


def test_renamed_result_gets_its_lines(live, grid_live):
    bpy.ops.dirichlet.make_isolines()
    result = grid_live.dirichlet.isolines
    grid_live.dirichlet.count = 7
    bpy.context.view_layer.update()
    live._tick()
    result.name = "Renamed"
    run_timer(live)
    assert len(result.data.splines) == 7


def test_a_newer_stroke_stops_what_live_computes_and_never_an_operator_on_the_same_mesh(live, module, grid_live):
    work, several = module("work"), module("several")
    grid_live.dirichlet.method = "lscg"
    operator = several.solve_fields([grid_live])
    task = next(operator).compute.args[0]
    grid_live.vertex_groups["left"].add([30], 1.0, "REPLACE")
    with task.session._lock:  # as the operator's thread would hold it
        task.session._current = task.cancel
        bpy.context.view_layer.update()
        live._tick()
        (follower,) = live._followers.values()
        assert follower.is_computing()  # it waits for the operator
        grid_live.vertex_groups["left"].add([31], 1.0, "REPLACE")
        bpy.context.view_layer.update()
        assert follower._work.field.cancel.is_cancelled
        assert not task.session._token.is_cancelled
        assert not task.cancel.is_cancelled
    operator.close()
    assert task.cancel.is_cancelled
    run_timer(live)
    assert grid_live.dirichlet.results.problem == ""
    assert work.threads._running == set()


def test_newer_levels_stop_lines_that_are_traced_in_a_thread(live, module, grid_live, monkeypatch):
    grid_live.dirichlet.live = False  # so that no field is due with them
    grid_live.dirichlet.preview = True
    settle(live)
    line_task, newer = module("lines.line_task").LineTask, Event()
    trace_now = line_task.compute

    def trace_later(self, *how):
        newer.wait(10)
        return trace_now(self, *how)

    monkeypatch.setattr(line_task, "compute", trace_later)
    grid_live.dirichlet.count = 7
    live._tick()
    (follower,) = live._followers.values()
    (task,) = follower._work.lines.values()
    grid_live.dirichlet.count = 8
    newer.set()
    assert task.cancel.is_cancelled
    run_timer(live)
    assert len(live.preview_of(grid_live).lines) == 8
    assert grid_live.dirichlet.results.problem == ""
