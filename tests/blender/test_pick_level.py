# SPDX-License-Identifier: GPL-3.0-or-later
"""The isoline through a picked point."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import add, field_of, grid, painted_grid


def solved_grid():
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    return obj


def pick(*how, location=(4.5, 3.2, 0.0)):
    return bpy.ops.dirichlet.pick_level(*how, location=location)


def lines_of(obj):
    return [np.array([point.co[:3] for point in s.points]) for s in obj.dirichlet.isolines.data.splines]


def test_the_line_runs_through_the_picked_point():
    obj = solved_grid()
    obj.dirichlet.levels_mode = "LIST"
    pick()
    bpy.ops.dirichlet.make_isolines()
    (line,) = lines_of(obj)
    assert np.abs(line[:, 0] - 4.5).max() < 1e-5  # the grid's lines are straight


def test_the_level_at_a_vertex_is_its_value():
    obj = solved_grid()
    obj.dirichlet.levels_mode = "LIST"
    pick(location=obj.data.vertices[42].co)
    assert np.float32(obj.dirichlet.levels_list) == field_of(obj)[42]


def test_the_list_grows_by_what_is_picked():
    obj = solved_grid()
    obj.dirichlet.levels_mode = "LIST"
    for before, after in (("", "0.25"), ("0.5", "0.5, 0.25"), ("0.5;", "0.5, 0.25")):
        obj.dirichlet.levels_list = before
        pick(location=(2.75, 0, 0))
        assert obj.dirichlet.levels_list == after


@pytest.mark.parametrize(
    ("mode", "levels"), [("EVEN", "0.125, 0.375, 0.625, 0.875"), ("STEP", "0.25, 0.5, 0.75"), ("EQUAL_AREA", None)]
)
def test_from_another_mode_no_line_is_lost(mode, levels):
    obj = solved_grid()
    settings = obj.dirichlet
    settings.levels_mode, settings.count, settings.step, settings.levels_list = mode, 4, 0.25, "7"
    bpy.ops.dirichlet.make_isolines()
    before = np.array(settings.isolines.data["dirichlet_level"])
    pick(location=(5.5, 0, 0))
    assert settings.levels_mode == "LIST"
    assert levels is None or settings.levels_list == f"{levels}, 0.5"
    bpy.ops.dirichlet.make_isolines()
    assert set(before.astype(np.float32)) <= set(np.float32(settings.isolines.data["dirichlet_level"]))


def test_what_becomes_of_the_mode_is_said(capfd):
    solved_grid()
    pick(location=(5.5, 0, 0))
    assert "Level 0.5 added; those of Even are listed now" in capfd.readouterr().out
    pick(location=(2.75, 0, 0))
    assert "Level 0.25 added to the list" in capfd.readouterr().out


@pytest.mark.parametrize("mode", ["WEIGHT_PAINT", "VERTEX_PAINT"])
def test_it_picks_while_painting(mode):
    obj = solved_grid()
    obj.dirichlet.levels_mode = "LIST"
    bpy.ops.object.mode_set(mode=mode)
    pick(location=(5.5, 0, 0))
    assert obj.dirichlet.levels_list == "0.5"


def test_picking_is_one_undo_step():
    solved_grid()
    bpy.ops.ed.undo_push(message="solved")
    pick("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    settings = bpy.data.objects["Grid"].dirichlet
    assert (settings.levels_mode, settings.levels_list) == ("EVEN", "")


def test_a_list_that_is_not_of_numbers_stays_as_it_is():
    obj = solved_grid()
    obj.dirichlet.levels_mode, obj.dirichlet.levels_list = "LIST", "0.1, half"
    assert_refused(pick, obj, "'half', is not a number")


def test_where_the_field_is_undefined_there_is_no_level():
    obj = add([(x + 9 * piece, y, 0) for piece in (0, 1) for x, y in ((0, 0), (1, 0), (0, 1))], [(0, 1, 2), (3, 4, 5)])
    obj.vertex_groups.new(name="a").add([0], 1, "REPLACE")
    bpy.ops.dirichlet.patch_add_group()
    bpy.ops.dirichlet.solve_field()
    assert_refused(lambda *how: pick(*how, location=(9.2, 0.2, 0)), obj, "field is nan at vertex 3")


def test_without_a_field_it_says_what_to_do():
    grid()
    with pytest.raises(RuntimeError, match="Solve Field first"):
        pick()


def test_edit_mode_is_left_first():
    solved_grid()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="mode first"):
        pick()
