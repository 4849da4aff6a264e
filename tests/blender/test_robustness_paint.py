# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex groups in unusual numbers, under names of other things, with values at the ends of what Blender stores."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import field_of, grid, paint, painted_grid


def test_thousands_of_groups_are_read():
    obj = grid(100, 60)
    for k in range(5000):
        obj.vertex_groups.new(name=f"group {k}").add([k], 1.0, "REPLACE")
        patch = obj.dirichlet.patches.add()
        patch.group, patch.value = f"group {k}", k
    obj.vertex_groups["group 7"].add([5999], 0.25, "REPLACE")  # below the threshold
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert np.array_equal(field_of(obj)[:5000], np.arange(5000, dtype=np.float32))
    assert obj.dirichlet.results.painted == 5000
    assert {len(bpy.data.meshes), len(bpy.data.objects), len(bpy.data.scenes)} == {1}


def uv_map(obj):
    obj.data.uv_layers.new(name="left")


def corner_color(obj):
    obj.data.color_attributes.new("left", "BYTE_COLOR", "CORNER")


def face_attribute(obj):
    obj.data.attributes.new("left", "FLOAT", "FACE")


@pytest.mark.parametrize("add_namesake", [uv_map, corner_color, face_attribute], ids=lambda add: add.__name__)
def test_a_group_is_read_whatever_else_has_its_name(add_namesake):
    """By its name alone, geometry nodes find the other."""
    expected = painted_grid(name="Expected")
    bpy.ops.dirichlet.solve_field()
    obj = grid()
    add_namesake(obj)
    paint(obj, "left", range(0, 84, 12), 0.0)
    paint(obj, "right", range(11, 84, 12), 1.0)
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = obj
    bpy.ops.dirichlet.solve_field()
    assert np.array_equal(field_of(obj), field_of(expected))


def test_the_highest_values_that_blender_stores_are_solved_between():
    obj = painted_grid()
    highest = float(np.finfo(np.float32).max)
    obj.dirichlet.patches[0].value, obj.dirichlet.patches[1].value = -highest, highest
    bpy.ops.dirichlet.solve_field()
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    assert np.isfinite(field_of(obj)).all()
    assert (field_of(obj)[0], field_of(obj)[11]) == (-highest, highest)
    assert obj.dirichlet.results.lines == obj.dirichlet.count


def points_of(obj):
    """(P, 3) of the lines' curve."""
    return np.array([point.co[:3] for spline in obj.dirichlet.isolines.data.splines for point in spline.points])


def test_values_one_step_apart_have_all_lines_in_one_column():
    obj = painted_grid()
    above = float(np.nextafter(np.float32(1), np.float32(2)))
    obj.dirichlet.patches[0].value, obj.dirichlet.patches[1].value = 1.0, above
    bpy.ops.dirichlet.solve_field()
    assert set(field_of(obj).tolist()) == {1.0, above}
    bpy.ops.dirichlet.make_isolines()
    assert obj.dirichlet.results.lines == obj.dirichlet.count
    assert np.ptp(points_of(obj)[:, 0]) <= 1


def test_touching_patches_of_two_values_have_all_lines_between_them():
    """Row 3 changes sides in its middle, where the lines climb from one gap between rows to the next."""
    obj = grid()
    paint(obj, "low", range(42), 0.0)
    paint(obj, "high", range(42, 84), 1.0)
    bpy.ops.dirichlet.solve_field()
    assert obj.dirichlet.results.unknowns == 0
    obj.dirichlet.count = 5
    bpy.ops.dirichlet.make_isolines()
    assert obj.dirichlet.results.lines == 5
    heights = points_of(obj)[:, 1]
    assert 2 <= heights.min() < heights.max() <= 4


def test_one_value_everywhere_is_said_and_has_no_lines():
    obj = painted_grid()
    obj.dirichlet.patches[1].value = 0.0
    bpy.ops.dirichlet.solve_field()
    assert "every painted value is 0, so the field is constant" in obj.dirichlet.results.field_warnings
    assert_refused(bpy.ops.dirichlet.make_isolines, obj, "the field is 0 everywhere")


def test_a_group_listed_twice_counts_once_unless_its_values_differ():
    obj = painted_grid()
    again = obj.dirichlet.patches.add()
    again.group, again.value = "left", 0.0
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert obj.dirichlet.results.painted == 14
    again.value = 0.5
    assert_refused(
        bpy.ops.dirichlet.solve_field,
        obj,
        r"vertex 0 is in 'left' with value 0 and in 'left' with value 0.5 \(and 6 more vertices\)",
    )
