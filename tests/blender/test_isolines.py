# SPDX-License-Identifier: GPL-3.0-or-later
"""Make Isolines: the curve object, its splines, levels and materials."""

import importlib
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from scene import field_of, library_mesh, link, painted_grid


def make(obj):
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    assert obj.dirichlet.isolines is not None
    return obj.dirichlet.isolines


def points_of(spline):
    return np.array([point.co[:3] for point in spline.points], np.float32)


def test_operator_draws_exactly_what_the_library_extracts(sphere, surface):
    curve = make(sphere).data
    values = field_of(sphere).astype(np.float64)
    levels = surface.even_levels(values.min(), values.max(), 13)
    lines = surface.isolines(library_mesh(surface, sphere), values, levels)
    assert len(curve.splines) == len(lines) > 0
    for number, spline in enumerate(curve.splines):
        assert np.array_equal(points_of(spline), lines.line(number).astype(np.float32))
        assert spline.use_cyclic_u == lines.closed[number]
    assert list(curve["dirichlet_level"]) == lines.levels[lines.level].tolist()
    assert list(curve["dirichlet_closed"]) == lines.closed.astype(int).tolist()
    assert list(curve["dirichlet_length"]) == lines.length.tolist()


def test_every_line_of_a_closed_surface_is_cyclic(sphere):
    assert all(spline.use_cyclic_u for spline in make(sphere).data.splines)


def test_lines_of_a_sheet_end_on_its_border(sheet):
    splines = make(sheet).data.splines
    assert not any(spline.use_cyclic_u for spline in splines)
    assert {points_of(spline)[end][1] for spline in splines for end in (0, -1)} == {0.0, 6.0}


def test_level_is_where_the_field_takes_it(sheet):
    sheet.dirichlet.levels_mode = "LIST"
    sheet.dirichlet.levels_list = "0.25; 0.6,0.9"
    curve = make(sheet).data
    assert list(curve["dirichlet_level"]) == [0.25, 0.6, 0.9]
    for spline, level in zip(curve.splines, curve["dirichlet_level"], strict=True):
        assert np.allclose(points_of(spline)[:, 0], 8 * level, atol=1e-5)


def test_object_is_a_child_in_place_in_every_collection_of_the_mesh(sphere):
    other = bpy.data.collections.new("other")
    bpy.context.scene.collection.children.link(other)
    other.objects.link(sphere)
    sphere.location = (1, 2, 3)
    target = make(sphere)
    bpy.context.view_layer.update()
    assert target.name == "Sphere_isolines"
    assert target.type == "CURVE"
    assert target.parent == sphere
    assert target.matrix_world == sphere.matrix_world
    assert set(target.users_collection) == set(sphere.users_collection)
    assert bpy.context.active_object == sphere


def test_running_again_updates_the_same_object(sphere):
    target = make(sphere)
    target.data.bevel_depth = 0.5
    counts = len(bpy.data.objects), len(bpy.data.curves), len(bpy.data.materials)
    sphere.dirichlet.levels_mode = "LIST"
    sphere.dirichlet.levels_list = "0.5"
    assert make(sphere) == target
    assert len(target.data.splines) == 1
    assert target.data.bevel_depth == 0.5
    sphere.dirichlet.levels_mode = "EVEN"
    make(sphere)
    assert (len(bpy.data.objects), len(bpy.data.curves), len(bpy.data.materials)) == counts


def test_renaming_either_object_keeps_the_link(sphere):
    target = make(sphere)
    sphere.name, target.name = "Ball", "Rings"
    assert make(sphere) == target
    assert len(bpy.data.curves) == 1


def test_deleted_lines_come_back(sphere):
    bpy.data.collections.new("other")
    target = make(sphere)
    bpy.context.scene.collection.objects.unlink(target)
    assert make(sphere).users_collection == sphere.users_collection
    bpy.data.objects.remove(target)
    assert make(sphere).data.splines


def test_duplicated_mesh_gets_lines_of_its_own(sphere):
    target = make(sphere)
    bpy.ops.object.duplicate()
    copy = bpy.context.active_object
    assert make(copy) not in (target, None)
    assert sphere.dirichlet.isolines == target
    assert target.data.splines


def test_objects_sharing_a_mesh_have_lines_of_their_own(sphere):
    target = make(sphere)
    other = link(sphere.data, "Other")
    assert make(other) != target
    assert len(make(other).data.splines) == len(target.data.splines)


@pytest.mark.parametrize("count", [1, 2, 13, 100])
def test_count_is_the_number_of_levels(sheet, count):
    sheet.dirichlet.count = count
    assert len(set(make(sheet).data["dirichlet_level"])) == count
    assert sheet.dirichlet.results.levels == count


def test_steps_lie_inside_the_window_and_move_with_the_phase(sheet):
    settings = sheet.dirichlet
    settings.levels_mode, settings.step, settings.phase = "STEP", 0.25, 0.5
    assert list(make(sheet).data["dirichlet_level"]) == [0.125, 0.375, 0.625, 0.875]


def test_window_bounds_the_levels(sheet):
    settings = sheet.dirichlet
    settings.count, settings.window_low, settings.window_high = 2, 0.5, 0.75
    assert not settings.window_auto
    assert list(make(sheet).data["dirichlet_level"]) == [0.5625, 0.6875]


def test_sliders_keep_the_window_open_and_slide_it_as_a_whole():
    obj = painted_grid()
    obj.dirichlet.patches[1].value = 4.0
    bpy.ops.dirichlet.solve_field()
    settings = obj.dirichlet
    settings.window_low_place, settings.window_high_place = 0.25, 0.5
    settings.window_place = 1.0
    assert (settings.window_low, settings.window_high) == pytest.approx((3.0, 4.0))
    settings.window_place = 0.0
    assert (settings.window_low, settings.window_high) == pytest.approx((0.0, 1.0))
    settings.window_low_place = 0.9
    assert settings.window_low < settings.window_high == pytest.approx(1.0)
    settings.window_high_place = 0.0
    assert settings.window_low < settings.window_high
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}


def test_window_follows_the_field_until_it_is_set():
    obj = painted_grid(columns=9)
    obj.dirichlet.patches[1].value = 8.0
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.count = 2
    assert list(make(obj).data["dirichlet_level"]) == [2, 6]
    obj.dirichlet.window_low_place = 0.5
    assert (obj.dirichlet.window_low, obj.dirichlet.window_high) == (4, 8)
    assert list(make(obj).data["dirichlet_level"]) == [5, 7]


def test_a_window_never_set_begins_as_the_whole_range():
    obj = painted_grid(columns=9)
    obj.dirichlet.patches[1].value = 8.0
    bpy.ops.dirichlet.solve_field()
    settings = obj.dirichlet
    settings.window_auto = False
    assert (settings.window_low, settings.window_high) == (0, 8)
    settings.window_low = 2
    settings.window_auto = True
    settings.window_auto = False
    assert (settings.window_low, settings.window_high) == (2, 8)


def test_lines_take_the_color_of_their_level_on_the_ramp(addon, sheet):
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "0.25 0.6"
    curve = make(sheet).data
    ramp = importlib.import_module(f"{addon.__name__}.blender.look.material").find_ramp(sheet).color_ramp
    for spline, level in zip(curve.splines, (0.25, 0.6), strict=True):
        material = curve.materials[spline.material_index]
        shown = material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value
        assert np.allclose(shown, ramp.evaluate(level), atol=2e-3)
        assert np.allclose(material.diffuse_color, shown)


def test_many_levels_share_few_materials(sheet):
    sheet.dirichlet.count = 1000
    curve = make(sheet).data
    assert len(curve.materials) == 64
    used = [spline.material_index for spline in curve.splines]
    assert used == sorted(used)
    assert set(used) == set(range(64))


def test_material_that_the_user_put_on_a_line_stays(sheet):
    target = make(sheet)
    own = bpy.data.materials.new("own")
    target.data.materials[2] = own
    make(sheet)
    assert target.data.materials[2] == own


def test_thickness_is_a_fraction_of_the_size(sheet):
    diagonal = np.hypot(8, 6)
    target = make(sheet)
    assert target.data.bevel_depth == pytest.approx(0.002 * diagonal)
    sheet.dirichlet.bevel_depth = 0.01
    assert target.data.bevel_depth == pytest.approx(0.01 * diagonal)


def test_level_out_of_range_gives_no_line_and_a_warning(sheet, pipeline):
    make(sheet)
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "7"
    result = pipeline.make_isolines(sheet)
    assert len(result.object.data.splines) == 0
    assert result.warnings
    assert len(result.object.data["dirichlet_level"]) == 0
    assert sheet.dirichlet.results.lines == 0


def test_no_lines_on_a_piece_without_paint(sheet):
    values = field_of(sheet)
    values[:] = np.nan
    values[:27] = np.tile(np.arange(9) / 8, 3)
    sheet.data.attributes["dirichlet_field"].data.foreach_set("value", values)
    for spline in make(sheet).data.splines:
        assert points_of(spline)[:, 1].max() <= 2


def test_results_count_closed_and_open_lines(sphere, sheet):
    bpy.context.view_layer.objects.active = sphere
    make(sphere)
    assert sphere.dirichlet.results.closed == sphere.dirichlet.results.lines == 13
    bpy.context.view_layer.objects.active = sheet
    make(sheet)
    assert (sheet.dirichlet.results.closed, sheet.dirichlet.results.lines) == (0, 13)


def test_points_that_coincide_in_float32_are_one(addon):
    drawing = importlib.import_module(f"{addon.__name__}.blender.lines.outputs.drawing")
    step = 1e-12
    stay, close, vanish, vanish_open, return_to_start = (
        [0, step, 1, 2, 2 + step],
        [0, 1, 2, step],
        [3, 3 + step],
        [4, 4 + step],
        [5, 6, 5],
    )
    rows = [*stay, *close, *vanish, *vanish_open, *return_to_start]
    lines = SimpleNamespace(
        points=np.array([(1 + x, 0.0, 0.0) for x in rows]),
        offsets=np.array([0, 5, 9, 11, 13, 16]),
        closed=np.array([False, True, True, False, False]),
        level=np.arange(5),
        length=np.ones(5),
        levels=np.arange(5.0),
    )
    drawn = drawing.draw(lines, np.ones((5, 4), np.float32), np.ones(5, np.float32), 0.1)
    assert drawn.offsets.tolist() == [0, 3, 6, 9]
    assert np.array_equal(drawn.points[:, 0], [1, 2, 3, 2, 3, 1, 6, 7, 6])
    assert drawn.level.tolist() == [0, 1, 4]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda obj: setattr(obj.dirichlet.patches[0], "value", 0.5), "run Solve Field"),
        (lambda obj: setattr(obj.dirichlet.patches[1], "enabled", False), "run Solve Field"),
        (lambda obj: obj.vertex_groups["left"].add([1], 1.0, "REPLACE"), "run Solve Field"),
        (lambda obj: setattr(obj.vertex_groups["left"], "name", "west"), "has no vertex group 'left'"),
    ],
)
@pytest.mark.parametrize("operator", ["make_isolines", "result_refresh"])
def test_lines_of_a_field_older_than_its_patches_say_so(capfd, operator, change, reason):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    assert "older" not in capfd.readouterr().out
    change(obj)
    if operator == "result_refresh":
        bpy.context.view_layer.objects.active = obj.dirichlet.isolines
    assert getattr(bpy.ops.dirichlet, operator)() == {"FINISHED"}
    said = capfd.readouterr().out
    assert "the field of 'Grid' is older than its patches" in said
    assert reason in said
    assert reason in obj.dirichlet.results.isoline_warnings  # which the panel shows


def test_numbers_are_said_as_people_write_them(capfd):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    settings = obj.dirichlet
    settings.levels_mode, settings.levels_list = "LIST", "0.5"
    bpy.ops.dirichlet.make_isolines()
    assert "1 isoline at 1 level, 0 closed" in capfd.readouterr().out
    settings.levels_mode, settings.step = "STEP", -0.1
    with pytest.raises(RuntimeError, match=r"the step is -0\.1, but"):
        bpy.ops.dirichlet.make_isolines()
    settings.step = 0.1
    bpy.ops.dirichlet.make_isolines()
    assert list(obj.dirichlet.isolines.data["dirichlet_level"])[2] == 3 * 0.1
    obj.dirichlet.patches[0].value = 0.1
    obj.vertex_groups["right"].add([0], 1.0, "REPLACE")
    with pytest.raises(RuntimeError, match=r"'left' with value 0\.1 and"):
        bpy.ops.dirichlet.solve_field()
