# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels and fields that give no isolines: said in one sentence, with everything left as it was."""

import math

import bpy
import pytest
from refusal import assert_refused
from scene import painted_grid


def text_in_list(settings):
    settings.levels_mode, settings.levels_list = "LIST", "0.1 0.2 abc"


def nan_in_list(settings):
    settings.levels_mode, settings.levels_list = "LIST", "0.1 nan"


def infinity_in_list(settings):
    settings.levels_mode, settings.levels_list = "LIST", "inf"


def empty_list(settings):
    settings.levels_mode, settings.levels_list = "LIST", " , "


def no_levels(settings):
    settings.count = 0


def fewer_than_no_levels(settings):
    settings.count = -1


def step_zero(settings):
    settings.levels_mode, settings.step = "STEP", 0


def step_negative(settings):
    settings.levels_mode, settings.step = "STEP", -0.1


def step_far_too_small(settings):
    settings.levels_mode, settings.step = "STEP", 1e-9


def window_reversed(settings):
    settings.window_low, settings.window_high = 0.8, 0.2


def window_empty(settings):
    settings.window_low = settings.window_high = 0.5


LEVEL_BREAKS = {
    text_in_list: "level 3 of the list, 'abc', is not a number",
    nan_in_list: "nan",
    infinity_in_list: "inf",
    empty_list: "list of levels is empty",
    no_levels: "0",
    fewer_than_no_levels: "-1",
    step_zero: "step",
    step_negative: "step",
    step_far_too_small: "levels",
    window_reversed: "0.8",
    window_empty: "0.5",
}


@pytest.mark.parametrize("made_before", [False, True])
@pytest.mark.parametrize("broken", LEVEL_BREAKS, ids=lambda broken: broken.__name__)
def test_make_isolines_refuses(broken, made_before):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    if made_before:
        bpy.ops.dirichlet.make_isolines()
    broken(obj.dirichlet)
    assert_refused(bpy.ops.dirichlet.make_isolines, obj, LEVEL_BREAKS[broken])


def test_make_isolines_asks_for_a_field_first():
    assert_refused(bpy.ops.dirichlet.make_isolines, painted_grid(), r"poll\(\) Solve Field first")


def test_make_isolines_refuses_a_field_undefined_everywhere():
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    obj.data.attributes["dirichlet_field"].data.foreach_set("value", [math.nan] * len(obj.data.vertices))
    assert_refused(bpy.ops.dirichlet.make_isolines, obj, "undefined everywhere")


def test_make_isolines_refuses_an_infinite_field():
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    obj.data.attributes["dirichlet_field"].data[5].value = math.inf
    assert_refused(bpy.ops.dirichlet.make_isolines, obj, "inf")
