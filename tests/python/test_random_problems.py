# SPDX-License-Identifier: GPL-3.0-or-later
"""The laws on meshes and paintings that nobody thought of."""

import numpy as np
import scipy.sparse.csgraph
from dirichlet_surface import DirichletError, HarmonicSolver, Mesh, even_levels, inspect_patches, isolines, solve
from hypothesis import given, note
from hypothesis import strategies as st
from isoline_laws import assert_sound
from mesh_makers import Soup, adjacency, polygons
from numpy.testing import assert_allclose, assert_array_equal
from random_meshes import meshes, polygon_grids, problems, tetrahedron_trees


def pieces_of(soup: Soup) -> np.ndarray:
    return scipy.sparse.csgraph.connected_components(adjacency(soup))[1]


@given(problems())
def test_painted_values_range_and_undefined_pieces(problem):
    soup, vertices, values = problem
    field = solve(soup.mesh(), vertices, values)
    assert_array_equal(field.values[vertices], values)
    piece = pieces_of(soup)
    for number in range(piece.max() + 1):
        inside, painted = field.values[piece == number], values[piece[vertices] == number]
        if len(painted):
            assert painted.min() <= inside.min()
            assert inside.max() <= painted.max()
        else:
            assert np.isnan(inside).all()
    assert field.report.undefined == np.isnan(field.values).sum()


@given(problems())
def test_free_vertices_are_the_average_of_their_neighbours(problem):
    soup, vertices, values = problem
    scale = np.abs(values).max() or 1.0
    field = solve(soup.mesh(), vertices, values).values / scale
    free = np.isfinite(field)
    free[vertices] = False
    A = adjacency(soup)
    valence = A.sum(axis=1).A1
    residual = valence * field - A @ np.nan_to_num(field)
    assert (np.abs(residual) <= 1e-10 + valence * 5e-324 / scale)[free].all()  # no float lies between 0 and 5e-324


@given(problems())
def test_both_methods_agree(problem):
    soup, vertices, values = problem
    scale = np.abs(values).max() or 1.0
    direct, lscg = (solve(soup.mesh(), vertices, values, method=method).values for method in ("direct", "lscg"))
    assert_allclose(lscg / scale, direct / scale, rtol=0, atol=1e-8)


@given(problems())
def test_indicator_fields_are_a_partition_of_unity(problem):
    soup, vertices, _ = problem
    fields = HarmonicSolver(soup.mesh(), vertices).solve(np.eye(len(vertices)))
    defined = ~np.isnan(fields).any(axis=1)
    assert (fields[defined] >= 0).all()
    assert_allclose(fields[defined].sum(axis=1), 1, atol=1e-12)


@given(problems(), st.integers(1, 9))
def test_isolines_of_a_solved_field_are_sound(problem, count):
    soup, vertices, values = problem
    mesh = soup.mesh()
    field = solve(mesh, vertices, values)
    if field.report.minimum < field.report.maximum:
        levels = even_levels(field.report.minimum, field.report.maximum, count)
        lines = isolines(mesh, field.values, levels)
        assert_sound(mesh, field.values, lines)


@given(meshes, st.integers(0, 10**6), st.integers(2, 5))
def test_isolines_of_fields_full_of_ties_are_sound(soup, seed, kinds):
    mesh = soup.mesh()
    random = np.random.default_rng(seed)
    values = random.integers(0, kinds, soup.size).astype(float)
    values[random.random(soup.size) < 0.05] = np.nan
    lines = isolines(mesh, values, [0.0, 0.5, 1.0, 1.25, 2.0])
    assert_sound(mesh, values, lines)


@given(tetrahedron_trees(), st.integers(0, 10**6))
def test_every_line_on_a_closed_manifold_is_closed(soup, seed):
    mesh = soup.mesh()
    _, faces_per_edge = np.unique(
        np.sort([edge for face in soup.faces for edge in zip(face, face[1:] + face[:1])], axis=1),
        axis=0,
        return_counts=True,
    )
    values = np.random.default_rng(seed).integers(0, 5, soup.size).astype(float)
    lines = isolines(mesh, values, [0.5, 1.0, 2.0, 3.5])
    note(f"faces per edge: {faces_per_edge}")
    assert lines.closed.all() or (faces_per_edge != 2).any()


@given(st.one_of(polygon_grids(), tetrahedron_trees()), st.data())
def test_facts_of_patches_count_what_is_there(soup, data):
    patch = data.draw(st.lists(st.integers(0, soup.size - 1), max_size=12))
    facts = inspect_patches(soup.mesh(), [np.array(patch, dtype=int)])[0]
    members = set(patch)
    A = adjacency(soup)[sorted(members)][:, sorted(members)]
    assert facts.vertices == len(members)
    assert facts.edges == A.nnz // 2
    assert facts.components == (scipy.sparse.csgraph.connected_components(A)[0] if members else 0)
    assert facts.euler_characteristic == facts.vertices - facts.edges + facts.faces
    assert not facts.disc or (facts.components == facts.border_loops == facts.euler_characteristic == 1)


@given(st.lists(st.lists(st.integers(-2, 12), max_size=7), max_size=8), st.integers(0, 11))
def test_any_list_of_faces_is_a_mesh_or_a_clear_refusal(faces, vertex_count):
    positions = np.random.default_rng(0).normal(size=(vertex_count, 3))
    message = "fine"
    try:
        mesh = Mesh(positions, polygons(faces))
        isolines(mesh, np.nan_to_num(solve(mesh, [0], [1.0]).values), [0.5])
    except DirichletError as error:
        message = str(error)
    assert message
    assert "\n" not in message
