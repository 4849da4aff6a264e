# SPDX-License-Identifier: GPL-3.0-or-later
"""Every operator on damaged meshes: the laws hold, or a refusal says what and where."""

import re

import damage
import numpy as np
import pytest
from dirichlet_surface import DirichletError, HarmonicSolver, even_levels, isolines, solve
from dirichlet_surface.field import LAPLACIANS
from hypothesis import given, settings
from hypothesis import strategies as st
from isoline_laws import assert_sound
from mesh_makers import ZOO, Soup
from numpy.testing import assert_array_equal
from random_meshes import damaged_meshes, problems

KEEP_THE_PAINTED_RANGE = {"graph", "intrinsic_delaunay", "auto"}
WHOLE = ZOO["quad grid"]


def assert_refusal_is_clear(error: DirichletError) -> None:
    """One sentence with a number of a vertex or face, or about all of them."""
    sentence = str(error)
    assert "\n" not in sentence
    assert re.search(r"\d|\bno face has an area\b", sentence), sentence


def assert_lawful(soup: Soup, vertices: np.ndarray, values: np.ndarray, laplacian: str, levels: int) -> None:
    mesh = soup.mesh()
    field = solve(mesh, vertices, values, laplacian=laplacian)
    assert_array_equal(field.values[vertices], values)
    piece, count = mesh.components()
    painted = np.zeros(count, bool)
    painted[piece[vertices]] = True
    assert_array_equal(np.isnan(field.values), ~painted[piece])
    defined = field.values[painted[piece]]
    assert np.isfinite(defined).all()
    if laplacian in KEEP_THE_PAINTED_RANGE:
        low, high = np.full(count, np.inf), np.full(count, -np.inf)
        np.minimum.at(low, piece[vertices], values)
        np.maximum.at(high, piece[vertices], values)
        assert (low[piece][painted[piece]] <= defined).all()
        assert (defined <= high[piece][painted[piece]]).all()
    if defined.min() < defined.max():
        cuts = even_levels(defined.min(), defined.max(), levels)
        assert_sound(mesh, field.values, isolines(mesh, field.values, cuts))


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@settings(max_examples=200)
@given(problem=problems(damaged_meshes()), levels=st.integers(1, 9))
def test_laws_of_field_and_isolines(laplacian, problem, levels):
    try:
        assert_lawful(*problem, laplacian, levels)
    except DirichletError as error:
        assert_refusal_is_clear(error)


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@pytest.mark.parametrize("name", sorted(damage.KINDS))
def test_one_damage_alone_is_solved(name, laplacian):
    refused = []
    for seed in range(10):
        soup = damage.KINDS[name](WHOLE, np.random.default_rng(seed))
        vertices = np.unique(np.random.default_rng(seed).integers(soup.size, size=6))
        try:
            assert_lawful(soup, vertices, np.linspace(0, 1, len(vertices)), laplacian, 5)
        except DirichletError as error:
            assert_refusal_is_clear(error)
            refused.append(str(error))
    assert not refused or name == "corners in another order", refused  # a polygon may cross itself


@pytest.mark.parametrize("laplacian", LAPLACIANS)
@given(problem=problems(damaged_meshes()), data=st.data())
def test_the_field_after_any_strokes_is_a_new_solvers_bit_for_bit(laplacian, problem, data):
    soup, vertices, values = problem
    try:
        mesh = soup.mesh()
        solver = HarmonicSolver(mesh, laplacian=laplacian, method="direct")
        for count in data.draw(st.lists(st.integers(1, len(vertices)), min_size=1, max_size=5)):
            painted, column = vertices[:count], values[:count]
            fresh = solve(mesh, painted, column, laplacian=laplacian, method="direct")
            assert_array_equal(solver.paint(painted, column), fresh.values)
    except DirichletError as error:
        assert_refusal_is_clear(error)


def test_every_damage_changes_the_mesh():
    def is_changed(soup: Soup) -> bool:
        return soup.faces != WHOLE.faces or not np.array_equal(soup.positions, WHOLE.positions)

    assert len(damage.KINDS) >= 16
    for change in damage.KINDS.values():
        assert any(is_changed(change(WHOLE, np.random.default_rng(seed))) for seed in range(5)), change
