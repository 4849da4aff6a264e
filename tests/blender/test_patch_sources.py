# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches made of what a mesh has already: borders, pieces, attributes."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import add, grid, paint, painted_grid, painted_sphere


def patches_of(obj):
    """{group: (value, vertices)}"""
    result = {}
    for patch in obj.dirichlet.patches:
        index = obj.vertex_groups[patch.group].index
        found = [v.index for v in obj.data.vertices if any(g.group == index and g.weight == 1 for g in v.groups)]
        result[patch.group] = patch.value, found
    return result


def frame():
    """A 5 by 5 grid of vertices without its four middle faces: two borders and, of vertices, one hole in the middle."""
    columns = 5
    corners = [x + columns * y for y in range(4) for x in range(4) if not (x in (1, 2) and y in (1, 2))]
    faces = [(c, c + 1, c + columns + 1, c + columns) for c in corners]
    return add([(x, y, 0) for y in range(columns) for x in range(columns)], faces)


def two_strips():
    """Two grids of 3 by 2 vertices in one mesh, their vertices alternating."""
    place = [(x, y, z) for y in range(2) for x in range(3) for z in range(2)]
    quads = [(0, 1, 4, 3), (1, 2, 5, 4)]
    return add(place, [[2 * corner + z for corner in quad] for z in range(2) for quad in quads])


def attribute(obj, name, kind, domain, values):
    made = obj.data.attributes.new(name, kind, domain)
    made.data.foreach_set("color" if "COLOR" in kind else "value", np.ravel(values).tolist())
    return made


def test_every_border_loop_becomes_a_patch_and_values_go_on_from_the_highest():
    obj = frame()
    paint(obj, "before", [0], 7.0)
    bpy.ops.dirichlet.patches_from_borders()
    found = patches_of(obj)
    assert [value for value, _ in found.values()] == [7, 8, 9]
    outer = [k for k in range(25) if k % 5 in (0, 4) or k // 5 in (0, 4)]
    inner = [6, 7, 8, 11, 13, 16, 17, 18]
    assert sorted([found["Border"][1], found["Border.001"][1]]) == [outer, inner]
    assert obj.dirichlet.active_patch == 2


def test_every_connected_piece_becomes_a_patch_in_the_order_of_its_vertices():
    obj = two_strips()
    bpy.ops.dirichlet.patches_from_pieces()
    assert patches_of(obj) == {"Piece": (0, [0, 2, 4, 6, 8, 10]), "Piece.001": (1, [1, 3, 5, 7, 9, 11])}


def test_a_long_chain_with_shuffled_vertices_is_one_piece():
    order = np.random.default_rng(1).permutation(2000)
    obj = add([(k, k % 2, 0) for k in np.argsort(order)], [order[k : k + 3].tolist() for k in range(1998)])
    bpy.ops.dirichlet.patches_from_pieces()
    assert [len(vertices) for _, vertices in patches_of(obj).values()] == [2000]


@pytest.mark.parametrize("kind", ["FLOAT_COLOR", "BYTE_COLOR"])
def test_islands_of_one_color_are_patches_and_the_ground_is_none(kind):
    obj = grid(9, 5)
    colors = np.ones((45, 4))
    red, dark = [10, 11, 19, 20], [15, 16]
    colors[[*red, 43]] = (1, 0, 0, 1)
    colors[dark] = (0.9, 1, 1, 1)
    attribute(obj, "Spots", kind, "POINT", colors)
    bpy.ops.dirichlet.patches_from_attribute()
    assert sorted(vertices for _, vertices in patches_of(obj).values()) == [red, dark, [43]]
    assert list(patches_of(obj)) == ["Spots island", "Spots island.001", "Spots island.002"]


def test_with_the_background_it_is_a_patch_like_any_other():
    obj = grid(4, 3)
    attribute(obj, "side", "BOOLEAN", "POINT", [k % 4 < 1 for k in range(12)])
    bpy.ops.dirichlet.patches_from_attribute(attribute="side", background=False)
    found = [vertices for _, vertices in patches_of(obj).values()]
    assert found == [[0, 4, 8], [1, 2, 3, 5, 6, 7, 9, 10, 11]]


@pytest.mark.parametrize("domain", ["FACE", "CORNER"])
def test_vertices_where_face_sets_meet_belong_to_none_but_ground_has_no_say(domain):
    obj = grid(7, 2)
    sets = [0, 0, 1, 2, 2, 0]
    each = 4 if domain == "CORNER" else 1
    attribute(obj, "sets", "INT", domain, np.repeat(sets, each))
    bpy.ops.dirichlet.patches_from_attribute(attribute="sets")
    assert [vertices for _, vertices in patches_of(obj).values()] == [[2, 9], [4, 5, 11, 12]]


def test_an_attribute_of_edges_gives_its_ends():
    obj = grid(5, 2)
    marked = [set(edge.vertices) == {1, 6} for edge in obj.data.edges]
    attribute(obj, "seam", "BOOLEAN", "EDGE", marked)
    bpy.ops.dirichlet.patches_from_attribute(attribute="seam")
    assert [vertices for _, vertices in patches_of(obj).values()] == [[1, 6]]


def blended(obj):
    attribute(obj, "Blend", "FLOAT", "POINT", np.arange(len(obj.data.vertices)))


def vectors(obj):
    obj.data.attributes.new("Blend", "FLOAT_VECTOR", "POINT")


def one_value(obj):
    attribute(obj, "Blend", "INT", "POINT", np.zeros(len(obj.data.vertices), int))


@pytest.mark.parametrize(
    ("prepare", "sentence"),
    [
        (blended, r"83 islands of attribute 'Blend', more than the 64"),
        (vectors, "'Blend' is of type FLOAT_VECTOR"),
        (one_value, "there are no islands of attribute 'Blend'"),
        (lambda obj: None, "has no attribute 'Blend'"),
    ],
)
def test_attribute_that_gives_no_patches_is_refused(prepare, sentence):
    obj = grid()
    prepare(obj)
    assert_refused(lambda *how: bpy.ops.dirichlet.patches_from_attribute(*how, attribute="Blend"), obj, sentence)


def test_without_colors_the_sentence_asks_for_a_name():
    assert_refused(bpy.ops.dirichlet.patches_from_attribute, grid(), "no color attribute of its own")


def test_the_colors_of_the_field_are_not_taken_for_paint():
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    assert obj.data.color_attributes.active_color_name == "dirichlet_color"
    assert_refused(bpy.ops.dirichlet.patches_from_attribute, obj, "no color attribute of its own")


def test_closed_mesh_has_no_border():
    obj = painted_sphere(2)
    assert_refused(bpy.ops.dirichlet.patches_from_borders, obj, "no border loops of mesh 'Sphere'")


@pytest.mark.parametrize("name", ["borders", "pieces", "attribute"])
def test_all_patches_of_a_run_are_one_undo_step(name):
    obj = frame()
    attribute(obj, "Colors", "FLOAT_COLOR", "POINT", np.eye(25)[:, :4] * (np.arange(25) < 3)[:, None])
    bpy.ops.ed.undo_push(message="before")
    getattr(bpy.ops.dirichlet, f"patches_from_{name}")("EXEC_DEFAULT", True)
    assert len(obj.dirichlet.patches) >= 1
    bpy.ops.ed.undo()
    obj = bpy.context.active_object
    assert not obj.dirichlet.patches
    assert not obj.vertex_groups


@pytest.mark.parametrize("name", ["borders", "pieces", "attribute"])
def test_edit_mode_is_left_first(name):
    frame()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="mode first"):
        getattr(bpy.ops.dirichlet, f"patches_from_{name}")()
