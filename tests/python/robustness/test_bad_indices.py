# SPDX-License-Identifier: GPL-3.0-or-later
"""An index that is none is refused with its face or place; nothing wraps, nothing is dropped."""

import numpy as np
import pytest
from dirichlet_surface import Mesh, Patch, combine_patches, solve
from mesh_makers import polygons, sphere
from outcomes import obj_of, refusal

SPHERE = sphere(7, 10)
FACES = np.array(SPHERE.faces)


@pytest.mark.parametrize("bad", [-1, 72, 2**31 - 1])
def test_a_face_that_names_a_vertex_out_of_range_is_named(bad):
    faces = FACES.copy()
    faces[[5, 8], 1] = bad
    message = refusal(Mesh, SPHERE.positions, faces)
    assert f"face 5 names vertex {bad}, but the vertices are 0 to 71" in message
    assert "1 more corner" in message


@pytest.mark.parametrize("bad", [2**31, 2**32 + 1, -(2**40)])
def test_an_index_beyond_32_bits_does_not_wrap(bad):
    faces = FACES.astype(np.int64)
    faces[[5, 8], 1] = bad
    message = refusal(Mesh, SPHERE.positions, faces)
    assert f"faces have {bad} at row 5" in message
    assert "1 more" in message


@pytest.mark.parametrize(("bad", "index"), [("0", 0), ("73", 73), ("-999", -999)])
def test_a_face_in_a_file_is_refused_by_line(command, bad, index):
    lines = obj_of(SPHERE).splitlines()
    lines[72 + 5] = f"f 1 2 {bad}"
    message = command.refuses(command.write("mesh.obj", "\n".join(lines)), "--patch", "a=1@0,0,1,0")
    assert f"line {72 + 6}: the face names vertex {index}" in message


@pytest.mark.parametrize(
    ("face", "reason"),
    [
        ([4], "fewer than three"), ([4, 5], "fewer than three"), ([4, 5, 5], "fewer than three"),
        ([4, 5, 6, 5], "names vertex 5 twice"), ([4, 5, 4, 6], "names vertex 4 twice"),
    ],
)  # fmt: skip
def test_a_face_that_is_no_polygon_is_named_with_how_many_more(face, reason):
    message = refusal(Mesh, SPHERE.positions, polygons([[0, 1, 2], face, [1, 2, 3], face]))
    assert "face 1" in message
    assert reason in message
    assert "1 more" in message


@pytest.mark.parametrize("face", ["f 1", "f 1 2", "f 1 2 2", "f 1 2 3 2"])
def test_such_a_face_in_a_file_is_refused_by_line(command, face):
    content = obj_of(SPHERE) + face + "\n"
    assert "line 213" in command.refuses(command.write("mesh.obj", content), "--patch", "a=1@0,0,1,0")


@pytest.mark.parametrize("bad", [-1, 72])
def test_a_painted_vertex_out_of_range_is_named_with_its_place(command, bad):
    message = refusal(solve, SPHERE.mesh(), [0, bad, bad], [0.0, 1.0, 1.0])
    assert f"painted vertex {bad} (at place 1)" in message
    assert "1 more" in message
    assert f"patch 'a' has the vertex {bad}" in refusal(combine_patches, [Patch("a", [0, bad], 1.0)], 72)


def test_a_vertex_out_of_range_in_a_file_of_paint_is_named_with_its_patch(command):
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    assert "patch 'a' has the vertex 72" in command.refuses(mesh, *command.paint("a", 1, [3, 72]))


def test_two_faces_in_a_tuple_are_two_faces():
    triangles, quads = ([0, 1, 2], [1, 2, 3]), ([0, 1, 2, 3], [4, 5, 6, 7])
    for faces in (triangles, quads, tuple(map(np.array, quads))):
        np.testing.assert_array_equal(Mesh(SPHERE.positions, faces).corners, np.ravel(faces))
