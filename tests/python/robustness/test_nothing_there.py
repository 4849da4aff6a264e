# SPDX-License-Identifier: GPL-3.0-or-later
"""Where there is nothing to solve for or from, a sentence says what is missing."""

import numpy as np
import pytest
from dirichlet_surface import Mesh, Patch, combine_patches, solve
from mesh_makers import sphere
from outcomes import obj_of, refusal, warning_about

SPHERE = sphere(7, 10)
PLANE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


@pytest.mark.parametrize(
    ("content", "named"),
    [(b"", "mesh.obj is empty"), (PLANE, "mesh.obj has no faces"), (PLANE + "l 1 2\nl 2 3\n", "mesh.obj has no faces")],
    ids=["empty file", "no faces", "only edges"],
)
def test_a_file_without_a_surface_is_refused_by_name(command, content, named):
    assert named in command.refuses(command.write("mesh.obj", content), "--patch", "a=1@0,0,0,1")


@pytest.mark.parametrize("faces", [[], np.empty((0, 3), int), ([0], [])], ids=["list", "array", "offsets"])
def test_arrays_without_a_face_are_refused(faces):
    assert refusal(Mesh, SPHERE.positions, faces) == "the mesh has no faces"


def test_edges_in_place_of_faces_are_refused_by_face():
    assert "face 0 has fewer than three" in refusal(Mesh, SPHERE.positions, [[0, 1], [1, 2]])


def test_faces_without_vertices_are_refused():
    assert "face 0 names vertex 0" in refusal(Mesh, np.empty((0, 3)), [[0, 1, 2]])


def test_no_painted_group_is_refused(command):
    assert "nothing is painted" in refusal(combine_patches, [], SPHERE.size)
    assert "no vertex is painted" in refusal(solve, SPHERE.mesh(), [], [])
    assert "nothing is painted" in command.refuses(command.write("mesh.obj", obj_of(SPHERE)))


def test_an_empty_group_alone_is_refused_by_name(command):
    assert "'nobody' has no vertices" in refusal(combine_patches, [Patch("nobody", np.empty(0, int), 1.0)], SPHERE.size)
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    assert "'nobody' has no vertices" in command.refuses(mesh, *command.paint("nobody", 1, []))


def test_an_empty_group_among_others_is_a_warning_that_names_it(command):
    patches = [Patch("nobody", np.empty(0, int), 1.0), Patch("pole", np.array([0]), 0.5)]
    assert "'nobody'" in warning_about("no vertices", combine_patches(patches, SPHERE.size).warnings)
    mesh = command.write("mesh.obj", obj_of(SPHERE))
    output = command.accepts(mesh, *command.paint("nobody", 1, []), *command.paint("pole", 1, [0]))
    assert "'nobody'" in warning_about("no vertices", output.splitlines())
