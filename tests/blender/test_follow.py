# SPDX-License-Identifier: GPL-3.0-or-later
"""Results with Follow change with field, settings, shape and frame. Without a window no timer runs, so tests flush."""

import importlib

import bpy
import numpy as np
import pytest
from scene import painted_grid
from shapes import add_shape_key, add_wave, levels, points, points_on_shape


@pytest.fixture
def live(addon):
    return importlib.import_module(f"{addon.__name__}.blender.live")


@pytest.fixture
def sheet():
    """A solved grid whose isolines follow."""
    obj = painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    obj.dirichlet.isolines.dirichlet_isolines.follow = True
    return obj


def settle(live):
    bpy.context.view_layer.update()
    live.flush()


def another(obj, text):
    """A second result of the object, with these levels of its own."""
    first = obj.dirichlet.isolines
    first.dirichlet_isolines.locked = True
    bpy.ops.dirichlet.make_isolines()
    second = obj.dirichlet.isolines
    second.parent = None
    obj.dirichlet.isolines = first
    first.dirichlet_isolines.locked = False
    second.dirichlet_isolines.levels_mode, second.dirichlet_isolines.levels_list = "LIST", text
    return second


def test_settings_are_followed(live, sheet):
    sheet.dirichlet.count = 3
    settle(live)
    assert len(levels(sheet.dirichlet.isolines)) == 3


def test_a_new_field_is_followed(live, sheet):
    sheet.dirichlet.patches[1].value = 2.0
    bpy.ops.dirichlet.solve_field()
    settle(live)
    assert np.allclose(levels(sheet.dirichlet.isolines), 2 * (np.arange(13) + 0.5) / 13)


def test_results_of_one_source_follow_each_by_its_settings(live, sheet):
    second = another(sheet, "0.25")
    second.dirichlet_isolines.follow = True
    settle(live)
    assert levels(second) == [0.25]
    second.dirichlet_isolines.levels_list = "0.75"
    settle(live)
    assert levels(second) == [0.75]
    sheet.dirichlet.count = 2
    settle(live)
    assert (levels(second), levels(sheet.dirichlet.isolines)) == ([0.75], [0.25, 0.75])


@pytest.mark.parametrize("still", ["follow", "locked"])
def test_results_that_do_not_follow_stay(live, sheet, still):
    second = another(sheet, "0.25")
    second.dirichlet_isolines.follow = still != "follow"
    settle(live)
    before = levels(second)
    second.dirichlet_isolines.locked = still == "locked"
    second.dirichlet_isolines.levels_list = "0.75"
    sheet.dirichlet.count = 2
    settle(live)
    assert (levels(second), len(levels(sheet.dirichlet.isolines))) == (before, 2)


@pytest.mark.parametrize("live_too", [False, True])
def test_a_deleted_result_stays_deleted(live, sheet, live_too):
    result = sheet.dirichlet.isolines
    sheet.dirichlet.live = live_too
    settle(live)
    bpy.context.view_layer.objects.active = result
    sheet.select_set(False)
    result.select_set(True)
    bpy.ops.object.delete()
    sheet.dirichlet.count = 3
    settle(live)
    assert [obj.name for obj in bpy.context.scene.objects] == ["Grid"]


def test_following_answers_no_write_of_its_own(live, sheet, monkeypatch):
    sheet.dirichlet.count = 3
    settle(live)
    with monkeypatch.context() as counting:
        counting.setattr(live.Follower, "begin", lambda self, obj, **how: pytest.fail(f"begun again: {self.due()!r}"))
        for _ in range(3):
            bpy.context.view_layer.update()


def test_what_cannot_be_drawn_is_said_and_leaves_the_lines(live, sheet):
    sheet.dirichlet.count = 0
    settle(live)
    assert "0" in sheet.dirichlet.results.problem
    assert len(levels(sheet.dirichlet.isolines)) == 13


@pytest.mark.parametrize("bend", [add_shape_key, add_wave])
def test_lines_follow_the_deformed_surface(live, surface, sheet, bend):
    flat = points(sheet.dirichlet.isolines)
    bend(sheet)
    settle(live)
    bent = points(sheet.dirichlet.isolines)
    assert np.abs(bent - flat).max() > 0.1
    assert np.allclose(bent, points_on_shape(surface, sheet), atol=1e-5)


def test_make_isolines_draws_what_follows_on_the_deformed_surface(live, surface, sheet):
    add_shape_key(sheet)
    bpy.ops.dirichlet.make_isolines()
    assert np.allclose(points(sheet.dirichlet.isolines), points_on_shape(surface, sheet), atol=1e-5)


def test_without_follow_lines_are_made_where_the_surface_is_shown_and_stay_there(live, surface, sheet):
    sheet.dirichlet.isolines.dirichlet_isolines.follow = False
    flat = points(sheet.dirichlet.isolines)
    add_shape_key(sheet)
    settle(live)
    assert np.array_equal(points(sheet.dirichlet.isolines), flat)
    bpy.ops.dirichlet.make_isolines()
    assert np.allclose(points(sheet.dirichlet.isolines), points_on_shape(surface, sheet), atol=1e-5)


def test_modifiers_that_make_other_faces_are_not_followed(live, sheet):
    flat = points(sheet.dirichlet.isolines)
    sheet.modifiers.new("Subdivision", "SUBSURF")
    add_shape_key(sheet)
    settle(live)
    assert np.array_equal(points(sheet.dirichlet.isolines), flat)


def test_preview_follows_the_deformed_surface(live, surface, sheet):
    sheet.dirichlet.preview = True
    add_shape_key(sheet)
    settle(live)
    assert np.allclose(live.preview_of(sheet).lines.points, points_on_shape(surface, sheet), atol=1e-5)


def test_undo_is_followed(live, sheet):
    bpy.ops.ed.undo_push(message="before")
    sheet.dirichlet.count = 3
    bpy.ops.ed.undo_push(message="count")
    settle(live)
    bpy.ops.ed.undo()
    settle(live)
    assert len(levels(bpy.data.objects["Grid"].dirichlet.isolines)) == 13


def test_a_reloaded_file_goes_on_following(live, sheet, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    sheet = bpy.data.objects["Grid"]
    sheet.dirichlet.count = 3
    settle(live)
    assert len(levels(sheet.dirichlet.isolines)) == 3
