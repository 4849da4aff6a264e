# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes made by scripts, with indices that are none: the first bad face is named, and Blender is not asked about it.

Blender itself may crash when it evaluates such a mesh, as it does before every operator: so the add-on's functions are
called here, as scripts call them, and the mesh is gone before Blender looks at it.
"""

import bpy
import numpy as np
import pytest
from refusal import state
from scene import field_of, library_mesh, link, paint

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


def raw(corners, starts, sizes):
    """The square with these faces, unchecked, painted 0 at vertex 1 and 1 at vertex 3."""
    mesh = bpy.data.meshes.new("Raw")
    mesh.vertices.add(4)
    mesh.vertices.foreach_set("co", np.ravel(SQUARE).astype(np.float32))
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", np.array(corners, np.int32))
    mesh.polygons.add(len(starts))
    mesh.polygons.foreach_set("loop_start", starts)
    if bpy.app.version < (3, 6, 0):  # later it is where the next face begins
        mesh.polygons.foreach_set("loop_total", sizes)
    obj = link(mesh, "Raw")
    paint(obj, "a", [1], 0.0)
    paint(obj, "b", [3], 1.0)
    return obj


BROKEN = {
    "index beyond the vertices": ([0, 1, 2, 0, 2, 9], [0, 3], [3, 3], "face 1 names vertex 9, but the vertices are 0"),
    "negative index": ([0, 1, 2, 0, 2, -1], [0, 3], [3, 3], "face 1 names vertex -1, but the vertices are 0 to 3"),
    "two corners": ([0, 1, 2, 0, 2], [0, 3], [3, 2], "face 1 has fewer than three different vertices"),
    "one corner": ([0, 1, 2, 0], [0, 3], [3, 1], "face 1 has fewer than three different vertices"),
    "no corner": ([0, 1, 2], [0, 3], [3, 0], "face 1 has fewer than three different vertices: it has no corners"),
    "vertex twice": ([0, 1, 2, 3, 1, 2, 1, 3], [0, 4], [4, 4], "face 1 .*vertex 1"),
}  # fmt: skip
STRETCHES = {
    "end beyond the corners": (
        [0, 1, 2, 0, 2, 3], [0, 3], [3, 30],
        "face 1 of mesh 'Raw' begins at corner 3 and ends before 33, but the mesh has 6 corners",
    ),
    "begin beyond the corners": (
        [0, 1, 2, 0, 2, 3], [0, 300], [3, 3],
        "face 1 of mesh 'Raw' begins at corner 300 and ends before 303, but the mesh has 6 corners",
    ),
    "negative size": (
        [0, 1, 2, 0, 2, 3], [0, 3], [3, -3],
        "face 1 of mesh 'Raw' begins at corner 3",
    ),
}  # fmt: skip
if bpy.app.version < (3, 6, 0):  # faces own any stretch of the corners
    BROKEN |= STRETCHES


@pytest.mark.parametrize("broken", BROKEN)
def test_the_first_bad_face_is_named_and_nothing_written(surface, pipeline, broken):
    *arrays, sentence = BROKEN[broken]
    obj = raw(*arrays)
    try:
        before = state(obj)
        with pytest.raises(surface.DirichletError, match=sentence):
            pipeline.solve_field(obj)
        assert state(obj) == before
    finally:
        bpy.data.meshes.remove(obj.data)


def test_an_edge_that_ends_nowhere_is_named(module, surface):
    obj = raw([0, 1, 2, 0, 2, 3], [0, 3], [3, 3])
    try:
        obj.data.edges.add(2)
        obj.data.edges.foreach_set("vertices", [0, 1, 1, 77])
        with pytest.raises(surface.InputError, match=r"edge 1 of mesh 'Raw' ends at vertex 77, .* are 0 to 3"):
            module("work").run(module("paint.patch_sources").from_pieces(obj))
    finally:
        bpy.data.meshes.remove(obj.data)


def test_a_corner_repeated_in_succession_counts_once(surface, pipeline):
    obj = raw([0, 1, 2, 2, 0, 2, 3], [0, 4], [4, 3])
    values = pipeline.solve_field(obj).field.values
    triangles = surface.Mesh(np.array(SQUARE, float), np.array([[0, 1, 2], [0, 2, 3]]))
    assert np.array_equal(values, surface.solve(triangles, [1, 3], [0, 1]).values)
    assert len(obj.data.polygons) == 2


def test_faces_that_validate_would_delete_are_kept(surface, pipeline):
    """Blender deletes a face that is there twice, without a word, when it validates a mesh: so nothing here does."""
    obj = raw([0, 1, 2, 0, 2, 3, 0, 1, 2], [0, 3, 6], [3, 3, 3])
    mesh = library_mesh(surface, obj)
    pipeline.solve_field(obj)
    assert len(obj.data.polygons) == 3
    assert np.array_equal(field_of(obj), surface.solve(mesh, [1, 3], [0, 1]).values.astype(np.float32))
    copy = obj.data.copy()
    assert copy.validate()
    assert len(copy.polygons) == 2
