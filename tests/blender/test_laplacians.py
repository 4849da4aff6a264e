# SPDX-License-Identifier: GPL-3.0-or-later
"""The choice of Laplacian: the geometric ones see the shape, as it is or as modifiers leave it."""

import bpy
import numpy as np
import pytest
from following import settle
from refusal import assert_refused
from scene import add, field_of, library_mesh, paint, painted_grid
from shapes import add_shape_key, add_wave

GEOMETRIC = ("cotangent", "intrinsic_delaunay", "polygon", "auto")


def uneven(columns=9, name="Grid"):
    """A painted grid that is wider towards one corner, and not flat."""
    obj = painted_grid(columns=columns, name=name)
    for vertex in obj.data.vertices:
        vertex.co.x, vertex.co.y = vertex.co.x**1.5, vertex.co.y**1.3
        vertex.co.z = 0.2 * np.sin(vertex.co.x + vertex.co.y)
    return obj


def shown_mesh(surface, obj):
    """The library's mesh of the shape that is shown."""
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    faces = [tuple(polygon.vertices) for polygon in mesh.polygons]
    offsets = np.cumsum([0, *map(len, faces)])
    return surface.Mesh([tuple(vertex.co) for vertex in mesh.vertices], (offsets, np.concatenate(faces)))


def expected(surface, mesh, laplacian, columns=9, rows=7):
    """0 on the left column, 1 on the right."""
    size = columns * rows
    painted = [*range(0, size, columns), *range(columns - 1, size, columns)]
    return surface.solve(mesh, painted, [0] * rows + [1] * rows, laplacian=laplacian).values.astype(np.float32)


def assert_solved(surface, obj, mesh):
    assert np.array_equal(field_of(obj), expected(surface, mesh, obj.dirichlet.laplacian))


def test_the_choices_are_those_of_the_library(surface):
    items = bpy.types.Object.bl_rna.properties["dirichlet"].fixed_type.properties["laplacian"].enum_items
    assert items.keys() == list(surface.LAPLACIANS)


@pytest.mark.parametrize("laplacian", ["graph", *GEOMETRIC])
def test_operator_writes_what_the_library_computes(surface, laplacian):
    obj = uneven()
    obj.dirichlet.laplacian = laplacian
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert_solved(surface, obj, library_mesh(surface, obj))


def test_the_shape_counts_for_the_geometric_ones_alone():
    obj, fields = uneven(), {}
    for laplacian in ("graph", *GEOMETRIC):
        obj.dirichlet.laplacian = laplacian
        bpy.ops.dirichlet.solve_field()
        fields[laplacian] = field_of(obj)
    assert np.allclose(fields["graph"], np.tile(np.arange(9) / 8, 7))
    assert all(np.abs(fields[one] - fields["graph"]).max() > 0.05 for one in GEOMETRIC)


@pytest.mark.parametrize("laplacian", ["graph", "cotangent"])
def test_moved_vertices_make_a_solver_anew_where_the_laplacian_sees_them(surface, pipeline, laplacian):
    obj = uneven()
    obj.dirichlet.laplacian = laplacian
    pipeline.solve_field(obj)
    assert pipeline.solve_field(obj).field.report.update == "nothing"
    obj.data.vertices[40].co.z = 1.0
    assert pipeline.solve_field(obj).field.report.update == ("nothing" if laplacian == "graph" else "full")
    assert_solved(surface, obj, library_mesh(surface, obj))


def test_a_stroke_on_the_same_shape_keeps_the_solver(pipeline):
    obj = painted_grid(columns=40, rows=30)
    obj.dirichlet.laplacian, obj.dirichlet.use_modifiers = "intrinsic_delaunay", True
    add_wave(obj)
    pipeline.solve_field(obj)
    paint(obj, "left", [205])
    assert pipeline.solve_field(obj).field.report.update == "partial"


def test_use_modifiers_solves_on_the_shape_that_is_shown(surface):
    obj = uneven()
    obj.dirichlet.laplacian = "intrinsic_delaunay"
    add_wave(obj)
    bpy.ops.dirichlet.solve_field()
    assert_solved(surface, obj, library_mesh(surface, obj))
    obj.dirichlet.use_modifiers = True
    bpy.ops.dirichlet.solve_field()
    assert_solved(surface, obj, shown_mesh(surface, obj))


@pytest.fixture
def shaped(live):
    """Live, by the shape that is shown."""
    obj = uneven()
    obj.dirichlet.laplacian, obj.dirichlet.use_modifiers = "cotangent", True
    add_wave(obj)
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.live = True
    settle(live)
    bpy.ops.ed.undo_push(message="live")
    return obj


def test_live_follows_the_shape(live, surface, shaped):
    shaped.data.vertices[40].co.z = 1.0
    shaped.data.update()
    settle(live)
    assert_solved(surface, shaped, shown_mesh(surface, shaped))
    shaped.modifiers["Bend"].angle = 2.0
    settle(live)
    assert_solved(surface, shaped, shown_mesh(surface, shaped))
    shaped.dirichlet.laplacian = "polygon"
    settle(live)
    assert_solved(surface, shaped, shown_mesh(surface, shaped))


def test_live_follows_what_another_object_does_to_the_shape(live, surface, shaped):
    """Blender then tells of the object alone, not of its mesh."""
    handle = bpy.data.objects.new("Handle", None)
    bpy.context.collection.objects.link(handle)
    shaped.modifiers["Bend"].origin = handle
    settle(live)
    before = field_of(shaped)
    handle.location = (3.0, 1.0, 2.0)
    settle(live)
    assert not np.array_equal(field_of(shaped), before)
    assert_solved(surface, shaped, shown_mesh(surface, shaped))


def test_live_follows_undo_and_redo_of_the_shape(live, surface, shaped):
    before = field_of(shaped)
    shaped.modifiers["Bend"].angle = 2.0
    bpy.ops.ed.undo_push(message="bent")
    settle(live)
    bent = field_of(shaped)
    assert not np.array_equal(bent, before)
    for step, field in ((bpy.ops.ed.undo, before), (bpy.ops.ed.redo, bent)):
        step()
        settle(live)
        assert np.array_equal(field_of(bpy.data.objects["Grid"]), field)


def test_every_frame_of_a_deforming_mesh_has_its_own_field(live, surface):
    obj = uneven()
    obj.dirichlet.laplacian, obj.dirichlet.use_modifiers = "intrinsic_delaunay", True
    key = add_shape_key(obj)
    for frame, value in ((1, 0.0), (11, 2.0)):
        key.value = value
        key.keyframe_insert("value", frame=frame)
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.live = True
    settle(live)
    fields = []
    for frame in (1, 6, 11):
        bpy.context.scene.frame_set(frame)
        assert_solved(surface, obj, shown_mesh(surface, obj))
        fields.append(field_of(obj))
    assert len(np.unique(fields, axis=0)) == 3


def test_auto_says_what_it_took_and_why(capfd):
    obj = uneven()
    obj.dirichlet.laplacian = "auto"
    bpy.ops.dirichlet.solve_field()
    results = obj.dirichlet.results
    assert results.laplacian in ("polygon", "intrinsic_delaunay")
    assert results.reason
    assert f"{results.laplacian}: {results.reason}" in capfd.readouterr().out


def sliver():
    """Two triangles with an obtuse angle of nearly 180 degrees at vertex 1, which is free, over the edge painted 0."""
    obj = add([(-1, 0, 0), (0, 0.05, 0), (1, 0, 0), (0, 1, 0)], [(0, 2, 1), (0, 1, 3), (1, 2, 3)])
    paint(obj, "low", [0], 0.0)
    paint(obj, "high", [2], 1.0)
    return obj


def test_values_outside_are_said_where_the_laplacian_promises_nothing():
    obj = add([(0, 0, 0), (4, 0, 0), (2, 0.1, 0), (2, -0.1, 0)], [(0, 1, 2), (1, 0, 3)])
    paint(obj, "low", [2, 3], 0.0)
    paint(obj, "high", [1], 1.0)
    obj.dirichlet.laplacian = "cotangent"
    bpy.ops.dirichlet.solve_field()
    assert "1 value lies outside the painted range, by up to " in obj.dirichlet.results.field_warnings
    obj.dirichlet.laplacian = "intrinsic_delaunay"
    bpy.ops.dirichlet.solve_field()
    assert "outside" not in obj.dirichlet.results.field_warnings
    assert 0 <= field_of(obj).min() <= field_of(obj).max() <= 1


@pytest.mark.parametrize("change", ["laplacian", "shape"])
def test_lines_of_a_field_of_another_shape_or_laplacian_say_so(pipeline, change):
    obj = uneven()
    obj.dirichlet.laplacian = "cotangent"
    pipeline.solve_field(obj)
    assert pipeline.make_isolines(obj).warnings == ()
    if change == "shape":
        obj.data.vertices[40].co.z = 1.0
    else:
        obj.dirichlet.laplacian = "polygon"
    (warning,) = pipeline.make_isolines(obj).warnings
    assert warning == "the field of 'Grid' is older than its patches, shape or Laplacian: run Solve Field"


@pytest.mark.parametrize("laplacian", GEOMETRIC[:3])
def test_a_mesh_without_area_is_refused_but_by_the_graph(laplacian):
    obj = painted_grid(columns=9)
    for vertex in obj.data.vertices:
        vertex.co.y = 0.0
    obj.dirichlet.laplacian = laplacian
    assert_refused(bpy.ops.dirichlet.solve_field, obj, "none of the 48 faces has an area")
    bpy.data.objects["Grid"].dirichlet.laplacian = "graph"
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
