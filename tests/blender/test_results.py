# SPDX-License-Identifier: GPL-3.0-or-later
"""Results stay editable: they remember source and settings, are refreshed, locked, duplicated, removed."""

import bpy
import pytest
from refusal import assert_refused, data_counts
from scene import painted_grid

COLUMNS = 9  # the field is x / 8


@pytest.fixture
def sheet():
    obj = painted_grid(columns=COLUMNS)
    bpy.ops.dirichlet.solve_field()
    return obj


def make(obj):
    activate(obj)
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    return obj.dirichlet.isolines


def activate(obj):
    for other in bpy.context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj


def refresh(result):
    activate(result)
    assert bpy.ops.dirichlet.result_refresh() == {"FINISHED"}


def levels(result):
    return list(result.data["dirichlet_level"])


def duplicate(*objects, linked=False):
    """Copies, as the user makes them, in the same order."""
    activate(objects[0])
    for obj in objects:
        obj.select_set(True)
    before = set(bpy.data.objects)
    bpy.ops.object.duplicate(linked=linked)
    made = set(bpy.data.objects) - before
    return [next(copy for copy in made if copy.name.startswith(f"{obj.name}.")) for obj in objects]


def list_levels(settings, text):
    settings.levels_mode, settings.levels_list = "LIST", text


def test_a_result_remembers_source_and_settings(sheet):
    settings = sheet.dirichlet
    settings.count, settings.phase, settings.bevel_depth = 7, 0.25, 0.01
    settings.window_low, settings.window_high = 0.25, 0.75
    note = make(sheet).dirichlet_isolines
    assert note.source == sheet
    kept = (
        "levels_mode",
        "count",
        "step",
        "phase",
        "bevel_depth",
        "window_auto",
        "window_low",
        "window_high",
        "output",
    )
    assert {name: getattr(note, name) for name in kept} == {name: getattr(settings, name) for name in kept}


def test_a_window_that_follows_the_field_is_remembered_as_that(sheet):
    sheet.dirichlet.window_low = 0.25
    sheet.dirichlet.window_auto = True
    note = make(sheet).dirichlet_isolines
    assert (note.window_auto, note.window_low) == (True, 0.25)


def test_refreshing_a_bound_result_is_making_it_again(sheet):
    result = make(sheet)
    sheet.dirichlet.count = 3
    refresh(result)
    after = levels(result)
    assert len(after) == 3
    assert make(sheet) == result
    assert levels(result) == after
    assert sheet.dirichlet.results.lines == 3


def test_refreshing_shows_the_field_as_it_is_now(sheet):
    result = make(sheet)
    list_levels(sheet.dirichlet, "0.5")
    sheet.dirichlet.patches[1].value = 2.0
    activate(sheet)
    bpy.ops.dirichlet.solve_field()
    refresh(result)
    assert {point.co.x for point in result.data.splines[0].points} == {2.0}


def test_making_again_leaves_a_locked_result_and_makes_another(sheet):
    locked = make(sheet)
    locked.dirichlet_isolines.locked = True
    before = levels(locked)
    sheet.dirichlet.count = 3
    other = make(sheet)
    assert other != locked
    assert (len(levels(other)), levels(locked)) == (3, before)
    assert make(sheet) == other


def test_refresh_refuses_a_locked_result(sheet):
    result = make(sheet)
    result.dirichlet_isolines.locked = True
    activate(result)
    assert_refused(bpy.ops.dirichlet.result_refresh, sheet, r"poll\(\).*locked: switch off Lock")


def test_the_work_refuses_a_locked_result_too(sheet, surface, module):
    result = make(sheet)
    result.dirichlet_isolines.locked = True
    with pytest.raises(surface.InputError, match=f"'{result.name}' is locked"):
        module("several").refresh([result])


def test_results_of_one_source_keep_settings_of_their_own(sheet):
    list_levels(sheet.dirichlet, "0.25")
    first = make(sheet)
    first.dirichlet_isolines.locked = True
    list_levels(sheet.dirichlet, "0.75")
    second = make(sheet)
    first.dirichlet_isolines.locked = False
    refresh(first)
    assert (levels(first), levels(second)) == ([0.25], [0.75])
    list_levels(first.dirichlet_isolines, "0.3")
    refresh(first)
    assert levels(first) == pytest.approx([0.3])
    assert sheet.dirichlet.levels_list == "0.75"


@pytest.mark.parametrize("linked", [False, True])
def test_a_duplicated_result_has_settings_and_lines_of_its_own(sheet, linked):
    result = make(sheet)
    before = levels(result)
    (copy,) = duplicate(result, linked=linked)
    list_levels(copy.dirichlet_isolines, "0.5")
    refresh(copy)
    assert (levels(copy), levels(result)) == ([0.5], before)
    assert make(sheet) == result


def test_a_result_duplicated_with_its_mesh_is_bound_to_the_copy(sheet):
    result = make(sheet)
    sheet_copy, result_copy = duplicate(sheet, result)
    list_levels(sheet_copy.dirichlet, "0.5")
    assert make(sheet_copy) == result_copy
    assert result_copy.dirichlet_isolines.source == sheet_copy
    assert (len(levels(result)), make(sheet)) == (13, result)


def test_a_result_without_parent_is_refreshed_by_its_own_settings(sheet):
    result = make(sheet)
    result.parent = None
    sheet.dirichlet.count = 3
    assert make(sheet) != result
    refresh(result)
    assert len(levels(result)) == 13


def test_the_window_of_a_result_starts_at_its_sources_range(sheet):
    sheet.dirichlet.patches[1].value = 4.0
    bpy.ops.dirichlet.solve_field()
    result = make(sheet)
    result.parent = None
    result.dirichlet_isolines.window_low = 2.0
    assert (result.dirichlet_isolines.window_high, result.dirichlet_isolines.window_auto) == (4.0, False)


def test_thickness_of_a_result_of_its_own_is_changed_at_once(sheet):
    result = make(sheet)
    result.parent = None
    before = result.data.bevel_depth
    result.dirichlet_isolines.bevel_depth *= 2
    assert result.data.bevel_depth == pytest.approx(2 * before)


@pytest.mark.parametrize("output", ["MESH", "CURVE"])
def test_a_result_with_its_own_settings_keeps_them_in_another_output(sheet, output):
    sheet.dirichlet.output = "CURVE" if output == "MESH" else "MESH"
    result = make(sheet)
    result.parent = None
    note = result.dirichlet_isolines
    note.count, note.smooth, note.follow, note.output = 7, 3, True, output
    name = result.name
    for _ in range(2):
        refresh(bpy.data.objects[name])
        note = bpy.data.objects[name].dirichlet_isolines
        assert (note.source, note.count, note.smooth, note.follow, note.output) == (sheet, 7, 3, True, output)
        assert bpy.data.objects[name].type == output
        assert sheet.dirichlet.count == 13
    points = bpy.data.objects[name].data
    lines = points.attributes["dirichlet_line"].data if output == "MESH" else points.splines
    assert len({item.value for item in lines} if output == "MESH" else lines) == 7


def test_removing_takes_data_and_materials_and_selects_the_source(sheet):
    counts = data_counts()
    result = make(sheet)
    activate(result)
    assert bpy.ops.dirichlet.result_remove() == {"FINISHED"}
    assert data_counts() == counts
    assert bpy.context.active_object == sheet
    assert make(sheet).data.splines


def test_removing_a_result_leaves_what_others_use(sheet):
    result = make(sheet)
    (copy,) = duplicate(result, linked=True)
    activate(result)
    bpy.ops.dirichlet.result_remove()
    assert len(copy.data.splines) == 13
    assert all(copy.data.materials)


def test_selecting_the_source_makes_it_active_alone(sheet):
    result = make(sheet)
    activate(result)
    assert bpy.ops.dirichlet.result_select_source() == {"FINISHED"}
    assert (bpy.context.active_object, bpy.context.selected_objects) == (sheet, [sheet])


@pytest.mark.parametrize("operator", ["refresh", "remove", "select_source"])
def test_other_objects_are_refused(sheet, operator):
    assert_refused(getattr(bpy.ops.dirichlet, f"result_{operator}"), sheet, r"poll\(\) Select isolines first")


def test_a_result_whose_source_was_deleted_keeps_its_settings_for_another(sheet):
    sheet.dirichlet.count = 5
    result = make(sheet)
    activate(sheet)
    bpy.ops.object.delete()
    activate(result)
    for operator in ("result_refresh", "result_select_source"):
        with pytest.raises(RuntimeError, match="is gone: choose another as Source"):
            getattr(bpy.ops.dirichlet, operator)()
    assert result.dirichlet_isolines.count == 5
    other = painted_grid(name="Other")
    bpy.ops.dirichlet.solve_field()
    result.dirichlet_isolines.source = other
    refresh(result)
    assert len(levels(result)) == 5
    assert result.dirichlet_isolines.count == 5


@pytest.mark.parametrize("how", ["by the user", "from the file"])
def test_a_disowned_result_can_be_removed(sheet, how):
    result = make(sheet)
    if how == "by the user":
        activate(sheet)
        bpy.ops.object.delete()
    else:
        bpy.data.objects.remove(sheet)
    activate(result)
    assert bpy.ops.dirichlet.result_remove() == {"FINISHED"}
    assert not bpy.context.scene.objects
    assert not bpy.data.curves


def test_the_work_refuses_a_disowned_result_too(sheet, surface, module):
    result = make(sheet)
    activate(sheet)
    bpy.ops.object.delete()
    with pytest.raises(surface.InputError, match="has no mesh object that it was made of"):
        module("several").refresh([result])


def test_a_saved_file_remembers_results(sheet, tmp_path):
    first = make(sheet)
    first.dirichlet_isolines.locked, first.name = True, "First"
    sheet.dirichlet.count = 3
    make(sheet).name = "Second"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    sheet, first, second = (bpy.data.objects[name] for name in ("Grid", "First", "Second"))
    assert (first.dirichlet_isolines.locked, first.dirichlet_isolines.source) == (True, sheet)
    assert make(sheet) == second
    first.dirichlet_isolines.locked = False
    refresh(first)
    assert (len(levels(first)), len(levels(second))) == (13, 3)
