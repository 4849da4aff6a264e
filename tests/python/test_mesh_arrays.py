# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays in, arrays out: what is shared, what is converted, what is refused and how it is named."""

import dirichlet_surface as surface
import numpy as np
import pytest
from dirichlet_surface import DirichletError, HarmonicSolver, InputError, Mesh, TopologyError, solve
from mesh_makers import ZOO, Soup, adjacency, grid, joined, moebius, polygons, prism, sphere, tetrahedron
from numpy.testing import assert_array_equal
from paintings import random_paint

SPHERE = sphere(7, 10)
FACES = np.array(SPHERE.faces)


def refusal(kind, call, *args, **options) -> str:
    with pytest.raises(kind) as caught:
        call(*args, **options)
    message = str(caught.value)
    assert message
    assert "\n" not in message
    return message


# --- what goes in


@pytest.mark.parametrize("dtype", [np.int8, np.int32, np.int64, np.uint8, np.uint32, np.uint64, ">i4"])
def test_faces_of_any_whole_type_make_the_same_mesh(dtype):
    assert_array_equal(Mesh(SPHERE.positions, FACES.astype(dtype)).edges, SPHERE.mesh().edges)


@pytest.mark.parametrize(
    "positions",
    [
        SPHERE.positions.astype(np.float32).astype(np.float64).astype(np.float32),
        np.asfortranarray(SPHERE.positions.astype(np.float32).astype(float)),
        np.repeat(SPHERE.positions.astype(np.float32).astype(float), 2, axis=0)[::2],
        SPHERE.positions.astype(np.float32).tolist(),
        SPHERE.positions.astype(np.float32).astype(">f8"),
    ],
    ids=["float32", "Fortran order", "every other row", "lists", "big-endian"],
)
def test_positions_of_any_layout_hold_the_same_numbers(positions):
    assert_array_equal(Mesh(positions, FACES).positions, SPHERE.positions.astype(np.float32))


@pytest.mark.parametrize("name", ZOO)
def test_a_mesh_that_moved_is_the_one_made_of_its_positions(name):
    soup = ZOO[name]
    mesh, elsewhere = soup.mesh(), soup.positions[:, ::-1] * 2 + 1
    moved, made = mesh.moved(elsewhere), Soup(elsewhere, soup.faces).mesh()
    for array in ("positions", "offsets", "corners", "edges", "triangles"):
        assert_array_equal(getattr(moved, array), getattr(made, array))
    assert_array_equal(mesh.positions, soup.positions)


def test_a_mesh_moves_to_finite_positions_of_its_own_vertices_alone():
    mesh, beyond = SPHERE.mesh(), SPHERE.positions.copy()
    assert "positions" in refusal(InputError, mesh.moved, SPHERE.positions[1:])
    beyond[3, 1] = np.nan
    assert "vertex 3 has the coordinate nan" in refusal(InputError, mesh.moved, beyond)


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1e300])
def test_positions_that_were_spoiled_in_place_are_named_by_whatever_reads_them(bad):
    soup = grid(4, 4, triangles=True)
    mesh, field = soup.mesh(), np.arange(25.0)
    surface.isolines(mesh, field, [11.5])
    soup.positions[12, 1] = bad
    for read in (
        lambda: surface.isolines(mesh, field, [11.5]),
        lambda: surface.stiffness_matrix(mesh, "cotangent"),
        lambda: surface.lumped_mass(mesh, "polygon"),
        lambda: surface.equal_area_levels(mesh, field, 3),
        lambda: surface.equal_distance_levels(mesh, field, 3),
        lambda: solve(mesh, [0, 24], [0.0, 1.0], laplacian="auto"),
    ):
        assert f"vertex 12 has the coordinate {bad}" in refusal(InputError, read)


def test_faces_of_any_layout_make_the_same_mesh():
    for faces in (np.asfortranarray(FACES), np.repeat(FACES, 2, axis=0)[::2], FACES.tolist(), FACES[:, ::-1][:, ::-1]):
        assert_array_equal(Mesh(SPHERE.positions, faces).corners, FACES.ravel())


def test_values_of_any_layout_give_the_same_field():
    vertices, _ = random_paint(SPHERE.size)
    values = np.random.default_rng(0).normal(size=(len(vertices), 3)).astype(np.float32)
    solver = HarmonicSolver(SPHERE.mesh(), vertices)
    expected = solver.solve(values.astype(float))
    for same in (values, np.asfortranarray(values), np.repeat(values, 2, axis=0)[::2], values.tolist()):
        assert_array_equal(solver.solve(same), expected)
    assert expected.shape == (SPHERE.size, 3)
    assert solver.solve(values[:, 1]).shape == (SPHERE.size,)


def test_float64_positions_in_c_order_are_shared_not_copied():
    positions = SPHERE.positions.copy()
    assert np.shares_memory(Mesh(positions, FACES).positions, positions)


def test_shared_positions_outlive_their_first_name():
    positions = SPHERE.positions.copy()
    mesh = Mesh(positions, FACES)
    del positions
    junk = [np.ones((SPHERE.size, 3)) for _ in range(20)]
    assert_array_equal(mesh.positions, SPHERE.positions)
    assert len(junk) == 20


def test_views_outlive_their_mesh():
    edges = SPHERE.mesh().edges
    junk = [np.full_like(edges, 7) for _ in range(20)]
    assert_array_equal(edges, SPHERE.mesh().edges)
    assert len(junk) == 20


@pytest.mark.parametrize("name", ["positions", "offsets", "corners", "triangles", "edges"])
def test_a_mesh_cannot_be_changed_through_its_arrays(name):
    view = getattr(SPHERE.mesh(), name)
    with pytest.raises(ValueError, match="read-only"):
        view[0] = 0


# --- what comes out


@pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
def test_edges_are_the_polygon_edges_once_each(soup):
    upper = np.transpose(np.triu(adjacency(soup).toarray()).nonzero())
    mesh = soup.mesh()
    assert_array_equal(mesh.edges, upper)
    assert mesh.edges.dtype == np.int32
    assert (mesh.vertex_count, mesh.edge_count, mesh.face_count) == (soup.size, len(upper), len(soup.faces))


@pytest.mark.parametrize("soup", ZOO.values(), ids=ZOO.keys())
def test_triangles_cover_every_polygon_over_its_own_vertices(soup):
    triangles = soup.mesh().triangles
    expected = [tuple(sorted(set(face))) for face in soup.faces for _ in range(len(face) - 2)]
    assert triangles.shape == (len(expected), 3)
    assert all(set(triangle) <= set(face) for triangle, face in zip(triangles.tolist(), expected))


def test_components_are_numbered_by_their_lowest_vertex():
    soup = joined(grid(2, 1), tetrahedron())
    labels, count = Soup(np.vstack((soup.positions, [[9, 9, 9]])), soup.faces).mesh().components()
    assert count == 3
    assert_array_equal(labels, [0] * 6 + [1] * 4 + [2])


def test_border_loops_go_round_with_the_surface_on_their_left():
    offsets, vertices = grid(2, 1).mesh().border_loops()
    assert_array_equal(offsets, [0, 6])
    assert_array_equal(vertices, [0, 1, 2, 5, 4, 3])
    assert len(moebius(7).mesh().border_loops()[0]) == 2
    assert_array_equal(SPHERE.mesh().border_loops()[0], [0])


# --- legal oddities


def test_a_corner_repeated_in_succession_counts_once():
    quads = np.array([[0, 1, 2, 2], [0, 0, 2, 3]])
    assert_array_equal(Mesh(grid(1, 1).positions, quads).offsets, [0, 3, 6])


def test_a_polygon_of_five_thousand_corners_works():
    soup = prism(5000)
    field = solve(soup.mesh(), [0, 5000], [0.0, 1.0])
    assert field.report.undefined == 0
    assert soup.mesh().triangles.shape == (2 * 4998 + 2 * 5000, 3)


# --- refusals


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e200])
def test_a_coordinate_out_of_reach_is_named_by_vertex(bad):
    positions = SPHERE.positions.copy()
    positions[[11, 20], 1] = bad
    message = refusal(InputError, Mesh, positions, FACES)
    assert "vertex 11" in message
    assert "1 more" in message


@pytest.mark.parametrize("bad", [-1, 72, 2**31, 2**32 + 1, -(2**32) + 1])
def test_a_face_index_out_of_range_is_named_and_does_not_wrap(bad):
    faces = FACES.copy()
    faces[5, 1] = bad
    message = refusal(InputError, Mesh, SPHERE.positions, faces)
    assert str(bad) in message
    assert "face" in message


def test_a_face_index_beyond_63_bits_is_named_and_does_not_wrap():
    assert str(2**64 - 1) in refusal(InputError, Mesh, SPHERE.positions, np.array([[0, 1, 2**64 - 1]], np.uint64))
    message = refusal(InputError, Mesh, SPHERE.positions, [[0, 1, 2], [0, 1, 2**70]])
    assert f"{2**70} at row 1, which is not an index" in message
    assert f"{2**40} at its only place" in refusal(InputError, solve, SPHERE.mesh(), 2**40, [0.0])


def test_what_is_no_number_is_named_with_its_place():
    message = refusal(InputError, solve, SPHERE.mesh(), [0, 1, 2], [np.float32(0), None, None])
    assert "None at place 1 (and 1 more element)" in message
    assert "beyond the largest float64" in refusal(InputError, solve, SPHERE.mesh(), [0, 1], [0.0, 10**400])
    assert solve(SPHERE.mesh(), [0, 1], [0.0, 2**70]).values[1] == 2.0**70
    assert "'b' at row 1" in refusal(InputError, Mesh, SPHERE.positions, np.array([[0, 1, 2], [0, 1, "b"]], object))


def test_masked_numbers_are_refused_and_masks_without_any_are_not():
    positions = np.ma.array(SPHERE.positions)
    assert Mesh(positions, FACES).vertex_count == 72
    positions[5, 1] = np.ma.masked
    assert "positions are masked at row 5" in refusal(InputError, Mesh, positions, FACES)


def test_positions_at_any_byte_hold_the_same_numbers():
    shifted = np.frombuffer(b"\0" + SPHERE.positions.tobytes(), "<f8", offset=1).reshape(-1, 3)
    assert not shifted.flags.aligned
    mesh = Mesh(shifted, FACES)
    assert mesh.positions.flags.aligned
    assert_array_equal(mesh.positions, SPHERE.positions)


@pytest.mark.parametrize("face", [[3], [3, 4], [3, 4, 4], [3, 4, 5, 4], []])
def test_a_face_that_is_no_polygon_is_named(face):
    message = refusal(TopologyError, Mesh, SPHERE.positions, polygons([[0, 1, 2], face]))
    assert "face 1" in message


@pytest.mark.parametrize(
    "faces",
    [
        np.empty((0, 3), int), [], ([0], []), FACES.astype(float), FACES[:, :, None], FACES.ravel(), "faces", None,
        ([0, 3], [0, 1]), ([0, 2, 1, 3], [0, 1, 2]), ([1, 3], [0, 1, 2]), [[0, 1, 2], [0, 1]], ([0, 3], [[0, 1], [2]]),
    ],
    ids=[
        "none (0, 3)", "none", "none (offsets)", "float", "three dimensions", "flat", "text", "nothing",
        "offsets too long", "offsets descend", "offsets begin late", "ragged", "ragged corners",
    ],
)  # fmt: skip
def test_faces_of_the_wrong_form_are_refused(faces):
    refusal(DirichletError, Mesh, SPHERE.positions, faces)


@pytest.mark.parametrize(
    "positions",
    [np.zeros((72, 2)), np.zeros(72 * 3), np.zeros((72, 3), complex), "text", None, [[0, 0, 0], [1, 1]]],
    ids=["two columns", "flat", "complex", "text", "nothing", "ragged"],
)
def test_positions_of_the_wrong_form_are_refused(positions):
    refusal(InputError, Mesh, positions, FACES)


def test_a_mesh_without_vertices_is_refused():
    refusal(InputError, Mesh, np.empty((0, 3)), [[0, 1, 2]])


@pytest.mark.parametrize("bad", [-1, 72, 2**32 + 1])
def test_a_painted_vertex_out_of_range_is_named(bad):
    assert str(bad) in refusal(InputError, solve, SPHERE.mesh(), [0, bad], [0.0, 1.0])


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_a_painted_value_or_source_that_is_not_finite_is_named(bad):
    assert "place 2" in refusal(InputError, solve, SPHERE.mesh(), [5, 6, 7], [0.0, 1.0, bad])
    paint = HarmonicSolver(SPHERE.mesh()).paint
    assert "in column 1 the painted value at place 0" in refusal(InputError, paint, [5, 6], [[0.0, bad], [0.0, 1.0]])
    source = np.zeros(SPHERE.size)
    source[9] = bad
    assert "vertex 9" in refusal(InputError, solve, SPHERE.mesh(), [5, 6], [0.0, 1.0], source=source)


def test_one_vertex_with_two_values_is_named():
    message = refusal(InputError, solve, SPHERE.mesh(), [5, 6, 5], [0.0, 1.0, 2.0])
    assert "vertex 5" in message


@pytest.mark.parametrize(
    ("vertices", "values", "options"),
    [
        ([], [], {}),
        ([1, 2], [1.0], {}),
        ([1.5, 2.5], [0.0, 1.0], {}),
        ([[1, 2]], [0.0, 1.0], {}),
        ([1, 2], [[0.0, 1.0]], {}),
        ([1, 2], ["a", "b"], {}),
        ([1, 2], [0.0, 1.0], {"source": [1.0]}),
        ([1, 2], [0.0, 1.0], {"source": np.zeros((72, 1))}),
        ([1, 2], [0.0, 1.0], {"method": "jacobi"}),
        ([1, 2], [0.0, 1.0], {"laplacian": "cotan"}),
        ([1, 2], [0.0, 1.0], {"method": "lscg", "tolerance": 0.0}),
        ([1, 2], [0.0, 1.0], {"method": "lscg", "max_iterations": 0}),
    ],
)
def test_a_problem_that_does_not_fit_together_is_refused(vertices, values, options):
    refusal(InputError, solve, SPHERE.mesh(), vertices, values, **options)


def test_a_solver_that_does_not_converge_says_so():
    refusal(DirichletError, solve, sphere(20, 30).mesh(), [0, 601], [0.0, 1.0], method="lscg", max_iterations=3)


def test_a_report_before_any_solve_is_refused():
    solver = HarmonicSolver(SPHERE.mesh(), [1])
    with pytest.raises(InputError):
        _ = solver.report


@pytest.mark.parametrize("mesh", [None, SPHERE.positions, "sphere"], ids=["nothing", "positions", "text"])
def test_what_is_no_mesh_is_refused_by_name(mesh):
    calls = [
        (surface.HarmonicSolver,),
        (surface.solve, [0], [1.0]),
        (surface.isolines, [0.0], [0.5]),
        (surface.level_through_point, [0.0], [0.0, 0.0, 0.0]),
        (surface.inspect_patches, [[0]]),
        (surface.dirichlet_laplacian, [0]),
    ]
    for call, *arguments in calls:
        assert f"needs a Mesh, not {type(mesh).__name__}" in refusal(InputError, call, mesh, *arguments)


def test_a_field_in_place_of_its_values_is_refused_by_name():
    mesh = SPHERE.mesh()
    field = surface.solve(mesh, [0, 5], [0.0, 1.0])
    assert "not Field" in refusal(InputError, surface.isolines, mesh, field, [0.5])
