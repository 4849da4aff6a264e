# SPDX-License-Identifier: GPL-3.0-or-later
"""A number that is none, or beyond all use, is refused with its place, and how many more there are."""

import numpy as np
import pytest
from dirichlet_surface import (
    HarmonicSolver,
    Mesh,
    even_levels,
    isolines,
    level_through_point,
    solve,
    stepped_levels,
)  # fmt: skip
from mesh_makers import sphere
from outcomes import obj_of, refusal

SPHERE = sphere(7, 10)
NOT_FINITE = [np.nan, np.inf, -np.inf]


@pytest.mark.parametrize("bad", [*NOT_FINITE, 1e200, -1e200])
def test_a_coordinate_is_refused_by_vertex(bad):
    positions = SPHERE.positions.copy()
    positions[[5, 9], [0, 2]] = bad
    message = refusal(Mesh, positions, SPHERE.faces)
    assert "vertex 5 has the coordinate" in message
    assert "1 more coordinate" in message


@pytest.mark.parametrize("bad", ["nan", "inf", "-inf", "1e999"])
def test_a_coordinate_in_a_file_is_refused_by_line(command, bad):
    content = obj_of(SPHERE).splitlines()
    content[6] = f"v 0 {bad} 0"
    message = command.refuses(command.write("mesh.obj", "\n".join(content)), "--patch", "a=1@0,0,1,0")
    assert "mesh.obj, line 7" in message
    assert bad in message


def test_a_coordinate_of_1e200_in_a_file_is_refused_by_line(command):
    content = obj_of(SPHERE).splitlines()
    content[6] = "v 0 1e200 0"
    message = command.refuses(command.write("mesh.obj", "\n".join(content)), "--patch", "a=1@0,0,1,0")
    assert "mesh.obj, line 7: a coordinate is '1e200', which is not finite or beyond 1e150" in message


@pytest.mark.parametrize("bad", NOT_FINITE)
def test_a_painted_value_is_refused_by_place(command, bad):
    message = refusal(solve, SPHERE.mesh(), [5, 6, 7], [0.0, bad, bad])
    assert "at place 1" in message
    assert "1 more" in message
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    assert "patch 'a' has the value" in command.refuses(mesh, *command.paint("a", bad, [3, 4]))


@pytest.mark.parametrize("bad", NOT_FINITE)
def test_a_source_is_refused_by_vertex(bad):
    source = np.zeros(SPHERE.size)
    source[[9, 12]] = bad
    message = refusal(solve, SPHERE.mesh(), [5, 6], [0.0, 1.0], source=source)
    assert "vertex 9" in message
    assert "1 more vertex" in message


@pytest.mark.parametrize("bad", NOT_FINITE)
def test_a_level_is_refused_by_index(command, bad):
    message = refusal(isolines, SPHERE.mesh(), SPHERE.positions[:, 2], [0.0, bad, bad])
    assert "level 1" in message
    assert "1 more level" in message
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    assert repr(float(bad)) in command.refuses(mesh, *command.paint("a", 1, [3]), f"--levels=0,{bad!r}")


@pytest.mark.parametrize("bad", [np.inf, -np.inf])
def test_an_infinite_field_is_refused_by_vertex(bad):
    field = SPHERE.positions[:, 2].copy()
    field[[3, 4]] = bad
    message = refusal(isolines, SPHERE.mesh(), field, [0.0])
    assert "vertex 3" in message
    assert "1 more" in message


@pytest.mark.parametrize("bad", [*NOT_FINITE, "wide", None, 1j])
def test_windows_steps_points_and_tolerances_are_refused(bad):
    mesh = SPHERE.mesh()
    refusal(even_levels, 0, bad, 3)
    refusal(stepped_levels, 0, 1, bad)
    refusal(stepped_levels, 0, 1, 0.1, bad)
    refusal(level_through_point, mesh, SPHERE.positions[:, 2], [0, bad, 0])
    if bad is not None:
        refusal(HarmonicSolver, mesh, tolerance=bad)


def test_a_step_of_a_host_in_single_precision_is_shown_as_typed():
    assert "-0.1," in refusal(stepped_levels, 0, 1, float(np.float32(-0.1)))
