# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels at vertices, along edges, at the ends and beyond: a right line, or a warning that says why there is none."""

import numpy as np
import pytest
from dirichlet_surface import even_levels, isolines
from isoline_laws import assert_sound
from mesh_makers import grid, joined, sphere
from outcomes import obj_of, refusal, warning_about

SPHERE = sphere(7, 10)
HEIGHT = SPHERE.positions[:, 2]
PAINT = ["--patch", "low=0@0,0,-1,0", "--patch", "high=1@0,0,1,0"]


def lines_of(soup, field, levels):
    mesh = soup.mesh()
    lines = isolines(mesh, field, levels)
    assert_sound(mesh, np.asarray(field, float), lines)
    return lines


def test_a_level_at_vertices_or_along_edges_has_one_closed_line():
    for ring in range(7):
        lines = lines_of(SPHERE, HEIGHT, [HEIGHT[1 + 10 * ring]])
        assert len(lines) == 1
        assert lines.closed.all()
        assert lines.warnings == ()


def test_on_a_plateau_the_line_runs_along_its_rim():
    soup = grid(6, 6)
    field = np.minimum(soup.positions[:, 0], 3)
    lines = lines_of(soup, field, [3.0])
    np.testing.assert_array_equal(lines.points[:, 0], 3)
    assert lines.warnings == ()


def test_the_lowest_value_has_no_line_and_a_warning_by_place():
    lines = lines_of(SPHERE, HEIGHT, [0.0, -1.0])
    np.testing.assert_array_equal(lines.level, [0])
    assert lines.warnings == ("level -1 (at place 1) has no line, as the field does not cross it",)


def test_the_highest_value_at_a_single_vertex_has_no_line_and_a_warning():
    lines = lines_of(SPHERE, HEIGHT, [1.0, 0.0, -1.0])
    np.testing.assert_array_equal(lines.level, [1])
    assert lines.warnings == ("level 1 (at place 0) has no line, as the field does not cross it (and 1 more level)",)


def test_a_level_in_the_gap_between_two_pieces_has_no_line_and_a_warning():
    soup = joined(SPHERE, SPHERE)
    lines = lines_of(soup, np.concatenate((HEIGHT, HEIGHT + 10)), [5.0])
    assert "level 5 (at place 0) has no line" in lines.warnings[0]


def test_levels_out_of_range_warn_by_place_with_the_range():
    lines = lines_of(SPHERE, HEIGHT, [0.5, 7.0, -7.0])
    np.testing.assert_array_equal(lines.level, [0])
    assert lines.warnings == ("level 7 (at place 1) lies outside the field's range -1 to 1 (and 1 more level)",)


def test_a_level_one_ulp_out_of_range_is_told_apart_from_its_end():
    (message,) = lines_of(SPHERE, HEIGHT, [np.nextafter(1, 2)]).warnings
    assert message.startswith("level 1.0000000000000002 (at place 0) lies outside the field's range -1 to 1")


def test_repeated_levels_count_once_and_say_so():
    lines = lines_of(SPHERE, HEIGHT, [0.1, -0.2, 0.1, 0.1, 9.0, 9.0])
    np.testing.assert_array_equal(lines.level, [0, 1])
    assert warning_about("repeat", lines.warnings) == "3 of 6 levels repeat another and count once"
    assert "more level" not in warning_about("outside", lines.warnings)
    assert warning_about("repeat", lines_of(SPHERE, HEIGHT, [0.1, 0.1]).warnings).startswith("1 of 2 levels repeats")


def test_levels_one_ulp_apart_have_a_line_each():
    lines = lines_of(SPHERE, HEIGHT, [0.1, np.nextafter(0.1, 1)])
    np.testing.assert_array_equal(lines.level, [0, 1])
    assert lines.warnings == ()


@pytest.mark.parametrize("count", [0, -1])
def test_no_level_at_all_is_refused(command, count):
    assert f"is {count}" in refusal(even_levels, 0, 1, count)
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    assert f"the number of levels is {count}" in command.refuses(mesh, *PAINT, "--isolines", str(count))
    constant = command.refuses(mesh, *PAINT[:2], "--isolines", str(count))
    assert f"the number of levels is {count}" in constant


@pytest.mark.parametrize("step", ["0", "-1", "nan", "inf"])
def test_a_step_that_is_none_is_refused_and_any_other_is_none_too_small_for_a_constant_field(command, step):
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    for paint in (PAINT, PAINT[:2]):
        assert f"the step is {step}, but has to be positive" in command.refuses(mesh, *paint, f"--step={step}")
    assert "isolines: 0" in command.accepts(mesh, *PAINT[:2], "--step=1e-200")


def test_ten_thousand_levels_have_a_line_each():
    lines = lines_of(SPHERE, HEIGHT, even_levels(-1, 1, 10_000))
    np.testing.assert_array_equal(lines.level, np.arange(10_000))


def test_more_crossings_than_memory_holds_are_refused_with_their_number():
    ball = sphere(30, 36)  # 2160 triangles, each crossed by every level
    field = np.tile([0.0, 1.0, 2.0], ball.size)[: ball.size]
    field[[0, -1]] = 0.5
    message = refusal(isolines, ball.mesh(), field, np.linspace(0.9, 1.1, 1_000_000))
    assert "cross the triangles" in message


def test_hazards_of_levels_are_told_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    output = command.accepts(mesh, *PAINT, "--levels", "0,0.5,7,0.5")
    assert "warning: level 0 (at place 0) has no line" in output
    assert "warning: level 7 (at place 2) lies outside the field's range 0 to 1" in output
    assert "warning: 1 of 4 levels repeats another and counts once" in output
    assert "isolines: 1 on 4 levels, 1 closed, 0 open" in output
    assert "1 on 1 level, 1 closed" in command.accepts(mesh, *PAINT, "--levels", "0.5")
