# SPDX-License-Identifier: GPL-3.0-or-later
"""Paint of every kind gives exactly what was painted, or is refused with vertex and groups."""

import numpy as np
import pytest
from dirichlet_surface import Patch, combine_patches, isolines
from dirichlet_surface.field import LAPLACIANS
from mesh_makers import grid, sphere
from outcomes import obj_of, refusal, solved, warning_about

SPHERE = sphere(7, 10)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_mesh_painted_all_over_is_returned_exactly(laplacian):
    values = np.random.default_rng(0).normal(size=SPHERE.size)
    field, _ = solved(SPHERE.mesh(), np.arange(SPHERE.size), values, laplacian)
    np.testing.assert_array_equal(field.values, values)
    assert field.report.unknowns == 0


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("vertices", [[5], [5, 60]], ids=["one group", "all equal"])
def test_one_value_gives_exactly_that_constant_and_a_warning(laplacian, vertices):
    field, lines = solved(SPHERE.mesh(), vertices, [0.3] * len(vertices), laplacian)
    assert (field.values == 0.3).all()
    assert len(lines) == 0
    assert "0.3" in warning_about("constant", field.report.warnings)


def test_one_value_is_told_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    output = command.accepts(mesh, *command.paint("a", 0.3, [5]), "--out-lines", "lines.obj")
    assert "every painted value is 0.3" in warning_about("constant", output.splitlines())


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_between_patches_that_touch_all_lines_run_in_the_shared_column(laplacian):
    soup = grid(8, 5)
    column = soup.positions[:, 0]
    painted = np.flatnonzero((column == 3) | (column == 4))
    _, lines = solved(soup.mesh(), painted, (column[painted] == 4).astype(float), laplacian)
    assert len(lines) == 7
    assert lines.points[:, 0].min() > 3
    assert lines.points[:, 0].max() < 4


def test_a_vertex_in_two_groups_is_refused_with_both_and_the_way_out(command):
    patches = [Patch("left", np.array([3, 5]), 0.0), Patch("right", np.array([5, 3]), 1.0)]
    message = refusal(combine_patches, patches, SPHERE.size)
    assert message.startswith("vertex 3 is in 'left' with value 0 and in 'right' with value 1 (and 1 more vertex)")
    assert "an overlap rule decides: first, highest, average" in message
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    words = [*command.paint("left", 0, [3, 5]), *command.paint("right", 1, [5, 3])]
    assert message in command.refuses(mesh, *words)
    for rule, value in {"first": 0, "highest": 1, "average": 0.5}.items():
        assert (combine_patches(patches, SPHERE.size, rule).values == value).all()
        command.accepts(mesh, *words, *command.paint("pole", 2, [0]), "--overlap", rule)


def test_a_vertex_painted_twice_in_one_painting_is_refused_with_both_places():
    message = refusal(solved, SPHERE.mesh(), [5, 6, 5, 6], [0.0, 1.0, 2.0, 3.0])
    assert message.startswith("vertex 5 is painted with 0 (at place 0) and with 2 (at place 2)")
    assert "1 more" in message


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_group_repeated_with_the_same_value_counts_once(laplacian):
    patches = [Patch("a", np.array([0, 1]), 0.0), Patch("a", np.array([1, 0, 1]), 0.0), Patch("b", np.array([71]), 1.0)]
    painting = combine_patches(patches, SPHERE.size)
    np.testing.assert_array_equal(painting.vertices, [0, 1, 71])
    field, _ = solved(SPHERE.mesh(), painting.vertices, painting.values, laplacian)
    assert field.report.painted == 3


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_five_thousand_groups_are_solved(laplacian):
    soup = grid(100, 100)
    patches = [Patch(f"group {k}", np.array([2 * k]), float(k % 7)) for k in range(5000)]
    painting = combine_patches(patches, soup.size)
    field, _ = solved(soup.mesh(), painting.vertices, painting.values, laplacian)
    assert field.report.painted == 5000


def test_five_thousand_groups_are_solved_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(grid(100, 100)))
    words = [f"--patch=g{k}={k % 7}@{k % 101},{k // 101},0,0" for k in range(5000)]
    assert "10201 vertices" in command.accepts(mesh, *words, "--report", "report.json")


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize(
    ("low", "high"),
    [(-1e300, 1e300), (0, 1e300), (1e300, np.nextafter(1e300, 2e300)), (1, np.nextafter(1, 2)), (0, 5e-324)],
)
def test_huge_values_and_values_one_ulp_apart_are_exact(laplacian, low, high):
    mesh = SPHERE.mesh()
    field, _ = solved(mesh, [0, 71], [low, high], laplacian)
    assert (field.report.minimum, field.report.maximum) == (low, high)
    lines = isolines(mesh, field.values, [high])  # the upper of two neighbours has a line that touches it alone
    assert np.isfinite(lines.points).all()


def test_groups_one_ulp_apart_are_told_apart():
    above = np.nextafter(0.3, 1)
    message = refusal(combine_patches, [Patch("a", np.array([0]), 0.3), Patch("b", np.array([0]), above)], SPHERE.size)
    assert "value 0.3 " in message
    assert f"value {above!r}".replace("np.float64(", "").replace(")", "") in message
