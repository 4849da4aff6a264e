# SPDX-License-Identifier: GPL-3.0-or-later
"""A solver that lives: a painting's field does not depend on what was painted before."""

import numpy as np
import pytest
from dirichlet_surface import HarmonicSolver, InputError, solve
from hypothesis import given
from hypothesis import strategies as st
from mesh_makers import sphere
from numpy.testing import assert_allclose, assert_array_equal
from paintings import random_paint
from random_meshes import meshes

SPHERE = sphere(20, 30)


@st.composite
def paint_sequences(draw):
    """A mesh and paintings: vertices that may repeat, and values that depend on the vertex alone."""
    soup = draw(meshes)
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    sizes = draw(st.lists(st.integers(1, max(1, soup.size // 2)), min_size=1, max_size=6))
    paintings = []
    for size in sizes:
        vertices = random.integers(0, soup.size, size)
        if paintings and draw(st.booleans()):  # a stroke beside the last painting
            vertices = np.concatenate([paintings[-1][0], vertices])
        paintings.append((vertices, random.uniform(-3, 3, soup.size)[vertices]))
    return soup, paintings


@given(paint_sequences())
def test_the_field_after_any_strokes_is_a_new_solvers_bit_for_bit(sequence):
    soup, paintings = sequence
    mesh = soup.mesh()
    solver = HarmonicSolver(mesh, method="direct")
    for vertices, values in paintings:
        assert_array_equal(solver.paint(vertices, values), solve(mesh, vertices, values, method="direct").values)


@given(paint_sequences(), st.sampled_from([{"precision": "float32"}, {"method": "multigrid"}]))
def test_float32_and_multigrid_keep_to_the_tolerance_after_any_strokes(sequence, options):
    soup, paintings = sequence
    mesh = soup.mesh()
    solver = HarmonicSolver(mesh, **options)
    for vertices, values in paintings:
        field = solver.paint(vertices, values)
        assert solver.report.relative_residual <= 1e-10
        assert_allclose(field, solve(mesh, vertices, values).values, rtol=0, atol=1e-7)


def test_the_report_says_what_a_painting_took():
    solver = HarmonicSolver(SPHERE.mesh())
    vertices, values = random_paint(SPHERE.size)

    def update(*painting):
        solver.paint(*painting)
        return solver.report.update

    assert update(vertices, values) == "full"
    assert update(vertices, values) == "nothing"
    assert update(vertices, values[::-1]) == "values"
    assert update(vertices[1:], values[1:]) in ("partial", "full")
    assert 0 < solver.report.repeated <= 1


def test_a_painting_that_was_not_changed_takes_no_seconds_and_gives_the_same_bits():
    solver = HarmonicSolver(SPHERE.mesh())
    vertices, values = random_paint(SPHERE.size)
    first = solver.paint(vertices, values)
    assert_array_equal(solver.paint(vertices, values), first)
    assert [solver.report.seconds[stage] for stage in ("injection", "factorisation", "solve")] == [0, 0, 0]


def test_columns_are_painted_at_once():
    vertices, _ = random_paint(SPHERE.size)
    columns = np.random.default_rng(3).normal(size=(len(vertices), 5))
    solver = HarmonicSolver(SPHERE.mesh())
    assert_array_equal(solver.paint(vertices, columns), HarmonicSolver(SPHERE.mesh(), vertices).solve(columns))


def test_nothing_painted_is_refused_and_leaves_the_last_painting():
    solver = HarmonicSolver(SPHERE.mesh())
    with pytest.raises(InputError, match="no vertex is painted"):
        solver.solve([])
    field = solver.paint([3, 4], [0.0, 1.0])
    for vertices, values in (([], []), ([3, 602], [0.0, 1.0]), ([3, 4], [0.0]), ([3, 4], [0.0, np.nan])):
        with pytest.raises(InputError):
            solver.paint(vertices, values)
    assert_array_equal(solver.solve([0.0, 1.0]), field)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"method": "magic"}, "no method 'magic'; choose from: auto, direct, multigrid, lscg"),
        ({"precision": "float16"}, "no precision 'float16'; choose from: float64, float32"),
        ({"memory_budget": -1}, "memory_budget"),
        ({"tolerance": 1.0}, "tolerance"),
    ],
)
def test_options_out_of_range_are_refused(options, words):
    with pytest.raises(InputError, match=words):
        HarmonicSolver(SPHERE.mesh(), **options)


def test_what_does_not_fit_the_memory_budget_is_solved_by_multigrid():
    vertices, values = random_paint(SPHERE.size)
    small = solve(SPHERE.mesh(), vertices, values, memory_budget=1000)
    assert small.report.method == "multigrid"
    assert small.report.iterations > 0
    assert_allclose(small.values, solve(SPHERE.mesh(), vertices, values).values, rtol=0, atol=1e-8)
