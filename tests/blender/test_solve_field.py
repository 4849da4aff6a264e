# SPDX-License-Identifier: GPL-3.0-or-later
"""Solve Field: what it reads, what it writes."""

import importlib

import bpy
import numpy as np
import pytest
from scene import (
    add,
    colors_of,
    field_of,
    grid,
    library_mesh,
    link,
    paint,
    painted_grid,
    painted_sphere,
)

UNDEFINED_GREY = 0.21


def solve():
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}


@pytest.mark.parametrize("make", [painted_grid, painted_sphere])
def test_operator_writes_exactly_what_the_library_computes(make, surface):
    obj = make()
    painted = {
        vertex.index: patch.value
        for patch in obj.dirichlet.patches
        for vertex in obj.data.vertices
        if obj.vertex_groups[patch.group].index in [group.group for group in vertex.groups]
    }
    vertices = sorted(painted)
    expected = surface.solve(library_mesh(surface, obj), vertices, [painted[vertex] for vertex in vertices])
    solve()
    assert np.array_equal(field_of(obj), expected.values.astype(np.float32))


def test_field_is_linear_between_two_sides_of_a_grid():
    obj = painted_grid(columns=9)
    solve()
    columns = np.array([vertex.co.x for vertex in obj.data.vertices])
    assert np.allclose(field_of(obj), columns / 8, atol=1e-6)


def test_painted_values_are_kept_exactly_and_unclamped():
    obj = painted_grid()
    obj.dirichlet.patches[0].value = -123.456
    solve()
    assert field_of(obj)[0] == np.float32(-123.456)


def test_vertex_belongs_to_a_patch_from_the_threshold_on():
    obj = painted_grid(columns=9)
    paint(obj, "left", range(1, 63, 9), weight=0.25)
    solve()
    assert field_of(obj)[1] == pytest.approx(1 / 8, abs=1e-6)
    obj.dirichlet.threshold = 0.25
    solve()
    assert field_of(obj)[1] == 0


def test_threshold_zero_leaves_vertices_without_weight_free():
    obj = painted_grid(columns=9)
    obj.dirichlet.threshold = 0
    solve()
    assert field_of(obj)[4] == pytest.approx(0.5, abs=1e-6)


def test_weights_as_values_paint_every_vertex_with_a_weight():
    obj = painted_grid()
    patch = paint(obj, "middle", [5], weight=0.3)
    paint(obj, "middle", [29], weight=0.9)
    patch.weights_as_values = True
    solve()
    assert (field_of(obj)[[5, 29]] == np.float32([0.3, 0.9])).all()


def test_disabled_patch_is_left_free():
    obj = painted_grid(columns=9)
    paint(obj, "middle", range(4, 63, 9), value=7.0).enabled = False
    solve()
    assert field_of(obj)[4] == pytest.approx(0.5, abs=1e-6)


@pytest.mark.parametrize(("rule", "value"), [("first", 0.0), ("highest", 1.0), ("average", 0.5)])
def test_overlap_rule_decides(rule, value):
    obj = painted_grid()
    paint(obj, "right", [0])
    obj.dirichlet.overlap = rule
    solve()
    assert field_of(obj)[0] == value


def test_more_groups_than_one_batch_are_read():
    obj = grid(columns=60, rows=4)
    for k in range(60):
        paint(obj, f"group {k}", range(k, 240, 60), value=k * 1.5)
    solve()
    assert (field_of(obj)[:60] == 1.5 * np.arange(60, dtype=np.float32)).all()


def test_piece_without_paint_is_nan_and_grey_and_said(pipeline):
    obj = add([(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 0, 0), (6, 0, 0), (5, 1, 0)], [(0, 1, 2), (3, 4, 5)])
    paint(obj, "a", [0], 2.0)
    paint(obj, "b", [1], 3.0)
    result = pipeline.solve_field(obj)
    assert np.array_equal(np.isnan(field_of(obj)), [False] * 3 + [True] * 3)
    assert np.allclose(colors_of(obj)[3:], [UNDEFINED_GREY] * 3 + [1.0])
    assert any("3 vertices" in warning and "vertex 3" in warning for warning in result.warnings), result.warnings
    assert obj.dirichlet.results.undefined == 3


def test_mesh_shared_by_two_objects_is_read_and_written_once():
    obj = painted_grid()
    other = link(obj.data, "Other")
    patch = other.dirichlet.patches.add()
    patch.group, patch.value = "left", 5.0
    solve()
    assert (field_of(obj) == 5).all()
    assert len(bpy.data.meshes) == 1


def test_modifiers_and_other_objects_do_not_change_the_reading():
    obj = painted_grid(columns=9)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 2
    obj.hide_set(True)
    solve()
    assert field_of(obj)[4] == pytest.approx(0.5, abs=1e-6)


@pytest.mark.skipif(bpy.app.version >= (3, 6, 0), reason="faces own consecutive loops since Blender 3.6")
def test_faces_may_own_any_stretch_of_the_loops(surface):
    positions, quad, triangle = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (3, 0, 0)], (0, 1, 2, 3), (2, 1, 4)
    obj = add(positions, [quad, triangle])
    obj.data.loops.foreach_set("vertex_index", [*triangle, *quad])
    obj.data.polygons.foreach_set("loop_start", [3, 0])
    paint(obj, "a", [0], 0.0)
    paint(obj, "b", [4], 1.0)
    solve()
    mesh = surface.Mesh(positions, ([0, 4, 7], [*quad, *triangle]))
    assert np.array_equal(field_of(obj), surface.solve(mesh, [0, 4], [0, 1]).values.astype(np.float32))


@pytest.mark.parametrize("mode", ["OBJECT", "WEIGHT_PAINT", "VERTEX_PAINT"])
def test_both_operators_work_in_mode(mode):
    obj = painted_grid(columns=9)
    bpy.ops.object.mode_set(mode=mode)
    solve()
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    assert obj.mode == mode
    assert field_of(obj)[4] == pytest.approx(0.5, abs=1e-6)


def test_renamed_object_and_mesh_solve_again():
    obj = painted_grid()
    solve()
    before = field_of(obj)
    obj.name, obj.data.name = "Another", "Another mesh"
    solve()
    assert np.array_equal(field_of(obj), before)


def test_solving_again_adds_no_data():
    obj = painted_grid()
    solve()
    counts = len(bpy.data.materials), len(obj.data.attributes), len(obj.material_slots)
    solve()
    assert (len(bpy.data.materials), len(obj.data.attributes), len(obj.material_slots)) == counts


def test_weight_reading_leaves_nothing_behind(addon, surface):
    obj = painted_grid()
    painting = importlib.import_module(f"{addon.__name__}.blender.paint.painting")
    before = len(bpy.data.scenes), len(bpy.data.objects), len(bpy.data.node_groups), obj.data.users
    painting.read_painting(obj)
    assert (len(bpy.data.scenes), len(bpy.data.objects), len(bpy.data.node_groups), obj.data.users) == before


def test_weight_reading_does_not_make_blender_evaluate_the_mesh_again(addon):
    obj = painted_grid()
    bpy.context.view_layer.update()
    updated = []

    def handler(scene, depsgraph):
        updated.extend(type(update.id).__name__ for update in depsgraph.updates)

    importlib.import_module(f"{addon.__name__}.blender.paint.painting").read_painting(obj)
    bpy.app.handlers.depsgraph_update_post.append(handler)
    try:
        bpy.context.view_layer.update()
        assert "Mesh" not in updated
        obj.data.update()
        bpy.context.view_layer.update()
        assert "Mesh" in updated
    finally:
        bpy.app.handlers.depsgraph_update_post.remove(handler)


def test_results_tell_the_paper_table():
    obj = painted_grid(columns=12, rows=7)
    solve()
    results = obj.dirichlet.results
    assert (results.vertices, results.painted, results.unknowns) == (84, 14, 70)
    assert (results.minimum, results.maximum) == (0, 1)
    assert 0 <= results.residual < 1e-12
    assert results.connectivity_ms > 0
    assert results.solver_ms > 0


def test_all_methods_agree(pipeline):
    obj = painted_sphere(subdivisions=3)
    fields = {}
    for method in ("direct", "multigrid", "lscg"):
        obj.dirichlet.method = method
        field = pipeline.solve_field(obj).field
        fields[field.report.method] = field.values
    assert np.allclose(fields["direct"], fields["lscg"], rtol=0, atol=1e-8)
    assert np.allclose(fields["direct"], fields["multigrid"], rtol=0, atol=1e-8)
