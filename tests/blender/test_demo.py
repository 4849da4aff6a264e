# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo's file, recomputed from its vertex groups with SciPy and nothing of ours."""

import bpy
import numpy as np
import pytest
from in_new_blender import run_script
from scipy.sparse import coo_matrix, diags, identity
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import spsolve


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """The path of the demo's file, made here and now, without the picture."""
    folder = tmp_path_factory.mktemp("demo")
    done = run_script("demo.py", folder, "--quick")
    assert done.returncode == 0, done.stderr
    return folder / "demo.blend"


@pytest.fixture
def monkey(demo, _empty_file):
    bpy.ops.wm.open_mainfile(filepath=str(demo))
    return bpy.data.objects["Monkey"]


def field_of(obj):
    return np.array([item.value for item in obj.data.attributes["dirichlet_field"].data])


def painted_values(obj):
    """(V,) from the weights, NaN where free."""
    value_of = {obj.vertex_groups[patch.group].index: patch.value for patch in obj.dirichlet.patches if patch.enabled}
    values = np.full(len(obj.data.vertices), np.nan)
    for vertex in obj.data.vertices:
        for weight in vertex.groups:
            if weight.group in value_of and weight.weight >= obj.dirichlet.threshold:
                values[vertex.index] = value_of[weight.group]
    return values


def adjacency(obj):
    ends = np.array([tuple(edge.vertices) for edge in obj.data.edges])
    count = len(obj.data.vertices)
    return coo_matrix((np.ones(2 * len(ends)), (ends.ravel(), ends[:, ::-1].ravel())), (count, count)).tocsr()


def test_the_field_solves_the_papers_equation(monkey):
    painted = painted_values(monkey)
    A, M = adjacency(monkey), diags((~np.isnan(painted)).astype(float))
    assert connected_components(A)[0] == 3  # the eyes are pieces of their own
    eye = identity(len(painted))
    walk = diags(1 / A.sum(axis=1).A1) @ A
    matrix = (eye - M) @ (eye - walk) + M  # equation (3)
    expected = spsolve(matrix.tocsc(), np.nan_to_num(painted))
    # float32 holds values in [0, 1] to within 2⁻²⁵
    assert np.abs(field_of(monkey) - expected).max() <= 2**-25 + 1e-8


def test_it_has_thirty_thousand_vertices_and_five_values(monkey):
    assert len(monkey.data.vertices) >= 30_000
    assert len({patch.value for patch in monkey.dirichlet.patches}) >= 5
    assert len(np.unique(painted_values(monkey))) >= 5


def test_lines_lie_where_the_field_has_their_levels(monkey):
    curve = monkey.dirichlet.isolines.data
    field, count = field_of(monkey), monkey.dirichlet.count
    levels = (np.arange(count) + 0.5) / count * np.ptp(field) + field.min()
    assert np.allclose(np.unique(curve["dirichlet_level"]), levels, atol=1e-12)
    errors = [
        error
        for spline, level in zip(curve.splines, curve["dirichlet_level"])
        for point in spline.points.values()[::7]
        for error in distances_from_level(monkey.data, field, np.array(point.co[:3]), level, monkey)
    ]
    assert len(errors) > 500
    assert max(errors) < 1e-5


def distances_from_level(mesh, field, point, level, obj):
    """|field − level| at the point, by each edge of the nearest face that it lies on; none on a quad's diagonal."""
    _, _, _, face = obj.closest_point_on_mesh(point.tolist())
    for first, second in mesh.polygons[face].edge_keys:
        start, end = (np.array(mesh.vertices[vertex].co) for vertex in (first, second))
        place = np.dot(point - start, end - start) / np.dot(end - start, end - start)
        if np.linalg.norm(start + place * (end - start) - point) < 1e-7 and -1e-4 < place < 1 + 1e-4:
            yield abs(field[first] + place * (field[second] - field[first]) - level)


def test_colours_and_sidebar_show_when_the_file_opens(monkey):
    assert monkey.data.color_attributes.active_color_name == "dirichlet_color"
    assert monkey.dirichlet.results.solved
    spaces = [area.spaces.active for screen in bpy.data.screens for area in screen.areas if area.type == "VIEW_3D"]
    assert spaces
    assert all(space.shading.color_type == "VERTEX" and space.show_region_ui for space in spaces)


def test_solving_again_changes_nothing(monkey):
    before = field_of(monkey)
    bpy.context.view_layer.objects.active = monkey
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert np.array_equal(field_of(monkey), before)
