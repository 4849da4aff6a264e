# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve Field and Make Isolines on all selected meshes: all of them, or none."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused, state
from scene import field_of, grid, link, paint, painted_grid, painted_sphere


@pytest.fixture
def pair():
    """Two painted objects, both selected, the grid active."""
    return painted_sphere(subdivisions=2), painted_grid()


def reports(capfd, operator):
    capfd.readouterr()
    assert operator() == {"FINISHED"}
    return [line for line in capfd.readouterr().out.splitlines() if line.startswith(("Info", "Warning"))]


def test_all_selected_meshes_are_solved_and_drawn(pair):
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    for obj in pair:
        assert (field_of(obj).min(), field_of(obj).max()) == (0, 1)
        assert obj.dirichlet.results.solved
        assert len(obj.dirichlet.isolines.data.splines) == 13


def test_each_result_is_that_of_the_object_alone(pair):
    bpy.ops.dirichlet.solve_field()
    together = [field_of(obj) for obj in pair]
    for obj, expected in zip(pair, together, strict=True):
        for other in pair:
            other.select_set(other == obj)
        bpy.context.view_layer.objects.active = obj
        obj.data.attributes.remove(obj.data.attributes["dirichlet_field"])
        bpy.ops.dirichlet.solve_field()
        assert np.array_equal(field_of(obj), expected)


def test_one_summary_is_reported(pair, capfd):
    sphere, sheet = pair
    count = len(sphere.data.vertices) + len(sheet.data.vertices)
    (report,) = reports(capfd, bpy.ops.dirichlet.solve_field)
    assert report.startswith("Info: 2 fields: ")
    assert f" of {count} vertices solved in " in report
    (report,) = reports(capfd, bpy.ops.dirichlet.make_isolines)
    assert report == "Info: 26 isolines on 2 objects, 13 closed"


def test_what_is_not_selected_not_painted_or_no_mesh_is_left_alone(pair):
    sphere, sheet = pair
    sphere.select_set(False)
    bare = grid(name="Bare")
    light = bpy.data.objects.new("Light", bpy.data.lights.new("Light", "POINT"))
    bpy.context.collection.objects.link(light)
    light.select_set(True)
    bpy.context.view_layer.objects.active = sheet
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    assert sheet.dirichlet.isolines
    for obj in (sphere, bare):
        assert "dirichlet_field" not in obj.data.attributes
        assert obj.dirichlet.isolines is None


def test_results_that_are_selected_are_no_meshes_to_draw_on(pair):
    for obj in pair:
        obj.dirichlet.output = "MESH"
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    made = [obj.dirichlet.isolines for obj in pair]
    for result in made:
        result.select_set(True)
        result.data.attributes.new("dirichlet_field", "FLOAT", "POINT")
    bpy.ops.dirichlet.make_isolines()
    assert [obj.dirichlet.isolines for obj in (*pair, *made)] == [*made, None, None]


def overlap(obj):
    paint(obj, obj.dirichlet.patches[0].group, range(len(obj.data.vertices)))


def group_missing(obj):
    obj.dirichlet.patches[1].group = "nobody"


REFUSALS = {overlap: "object '{name}': vertex ", group_missing: "object '{name}' has no vertex group 'nobody'"}


@pytest.mark.parametrize("broken", [0, 1], ids=["the other", "the active one"])
@pytest.mark.parametrize("spoil", REFUSALS, ids=lambda spoil: spoil.__name__)
def test_a_refusal_of_one_names_it_and_leaves_all_as_they_were(pair, broken, spoil):
    spoil(pair[broken])
    names = [obj.name for obj in pair]
    before = [state(obj) for obj in pair]
    sentence = f"Error: {REFUSALS[spoil].format(name=names[broken])}"
    assert_refused(bpy.ops.dirichlet.solve_field, pair[1], sentence)
    assert [state(bpy.data.objects[name]) for name in names] == before


@pytest.mark.parametrize("broken", [0, 1], ids=["the other", "the active one"])
def test_levels_of_one_that_are_refused_leave_the_lines_of_all(pair, broken):
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    for obj in pair:
        obj.dirichlet.count = 3
    pair[broken].dirichlet.count = 0
    name = pair[broken].name
    assert_refused(bpy.ops.dirichlet.make_isolines, pair[1], f"object '{name}': .*0")
    for name in ("Sphere", "Grid"):
        assert len(bpy.data.objects[name].dirichlet.isolines.data.splines) == 13


def test_a_shared_mesh_is_solved_once_with_the_active_ones_patches(capfd):
    first = painted_grid()
    second = link(first.data, "Another")
    paint(second, "left", [], 5.0)
    paint(second, "right", [], 7.0)
    said = reports(capfd, bpy.ops.dirichlet.solve_field)
    assert said[1:] == ["Warning: 'Another' and 'Grid' share mesh 'Grid': the patches of 'Another' were used"]
    assert (field_of(first).min(), field_of(first).max()) == (5, 7)
    assert "fields" not in said[0]
    bpy.context.view_layer.objects.active = first
    bpy.ops.dirichlet.solve_field()
    assert (field_of(first).min(), field_of(first).max()) == (0, 1)


def test_lines_of_a_field_that_another_object_solved_on_the_same_mesh_say_so(capfd):
    first = painted_grid()
    bpy.ops.dirichlet.solve_field()
    second = link(first.data, "Another")
    paint(second, "left", [], 5.0)
    paint(second, "right", [], 7.0)
    first.select_set(False)
    bpy.ops.dirichlet.solve_field()
    second.select_set(False)
    first.select_set(True)
    bpy.context.view_layer.objects.active = first
    said = reports(capfd, bpy.ops.dirichlet.make_isolines)
    assert any("the field of 'Grid' is older than its patches" in line for line in said)


def test_objects_that_share_a_mesh_are_drawn_each_by_its_settings():
    first = painted_grid()
    second = link(first.data, "Another")
    bpy.context.view_layer.objects.active = first
    bpy.ops.dirichlet.solve_field()
    first.dirichlet.count, second.dirichlet.count = 3, 5
    bpy.ops.dirichlet.make_isolines()
    assert [len(obj.dirichlet.isolines.data.splines) for obj in (first, second)] == [3, 5]
