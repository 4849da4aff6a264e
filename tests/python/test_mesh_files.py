# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh files in and out, and what a damaged one is answered with."""

import numpy as np
import pytest
from dirichlet_surface import DirichletError, read_mesh, write_mesh
from file_texts import OBJ, PLY
from mesh_makers import grid, joined, sphere, tetrahedron
from numpy.testing import assert_allclose, assert_array_equal


def written(folder, name: str, content: str | bytes):
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path


def refusal(path) -> str:
    with pytest.raises(DirichletError) as caught:
        read_mesh(path)
    message = str(caught.value)
    assert path.name in message
    assert "\n" not in message
    return message


@pytest.mark.parametrize("ending", [".obj", ".ply", ".off"])
@pytest.mark.parametrize("soup", [sphere(5, 7), grid(4, 3, triangles=False)], ids=["triangles", "quads"])
def test_a_mesh_comes_back_from_its_file(tmp_path, soup, ending):
    write_mesh(tmp_path / f"mesh{ending}", soup.mesh())
    back = read_mesh(tmp_path / f"mesh{ending}")
    assert_allclose(back.positions, soup.positions, atol=1e-6)
    assert_array_equal(back.corners, soup.mesh().corners)
    assert_array_equal(back.offsets, soup.mesh().offsets)


def test_an_stl_file_comes_back_with_its_corners_joined(tmp_path):
    write_mesh(tmp_path / "mesh.stl", sphere(5, 7).mesh())
    back = read_mesh(tmp_path / "mesh.stl")
    assert (back.vertex_count, back.face_count, back.edge_count) == (37, 70, 105)


def test_pieces_and_lone_vertices_survive(tmp_path):
    soup = joined(tetrahedron(), tetrahedron())
    path = written(tmp_path, "lone.obj", OBJ.replace("f 1", "v 9 9 9\nf 1"))
    assert read_mesh(path).vertex_count == 4
    write_mesh(tmp_path / "two.off", soup.mesh())
    assert read_mesh(tmp_path / "two.off").components()[1] == 2


@pytest.mark.parametrize(
    "text",
    [
        OBJ.replace("\n", "\r\n"),
        "\ufeff" + OBJ,
        "# a comment\n\n" + OBJ,
        "f 1 2 3\n" + OBJ.replace("f 1 2 3\n", ""),
        OBJ.replace("f 1 2 3", "f -3 -2 -1"),
        OBJ.replace("f 1 2 3", "f 1/1 2/2 3/3") + "vt 0 0\n" * 3,
        OBJ.replace("f 1 2 3", "f 1 2 3 3"),
    ],
    ids=["CRLF", "BOM", "comments", "faces first", "negative indices", "texture indices", "repeated corner"],
)
def test_legal_oddities_of_obj_files_work(tmp_path, text):
    mesh = read_mesh(written(tmp_path, "odd.obj", text))
    assert_array_equal(mesh.positions, [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    assert_array_equal(np.sort(mesh.corners), [0, 1, 2])


@pytest.mark.parametrize("ending", [".obj", ".ply", ".off", ".stl"])
@pytest.mark.parametrize("content", [b"", b"\0" * 100, b"\xff\xfe junk \n 1 2 3"], ids=["empty", "zeros", "junk"])
def test_a_file_that_is_no_mesh_is_refused(tmp_path, ending, content):
    refusal(written(tmp_path, "bad" + ending, content))


@pytest.mark.parametrize("name", ["mesh.xyz", "mesh", "mesh.obj.gz"])
def test_an_unknown_ending_is_refused(tmp_path, name):
    refusal(written(tmp_path, name, OBJ))


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    refusal(tmp_path / "nowhere.obj")
    (tmp_path / "folder.obj").mkdir()
    refusal(tmp_path / "folder.obj")


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (OBJ.replace("v 1 0 0", "v 1 zero 0"), 2),
        (OBJ.replace("v 1 0 0", "v 1 0"), 2),
        (OBJ.replace("f 1 2 3", "f 1 2 4"), 4),
        (OBJ.replace("f 1 2 3", "f 1 2 -4"), 4),
        (OBJ.replace("f 1 2 3", "f 0 1 2"), 4),
        (OBJ.replace("f 1 2 3", "f 1 2 x"), 4),
        (OBJ.replace("f 1 2 3", "f 1 2 4294967299"), 4),
    ],
)
def test_a_damaged_obj_file_is_refused_by_line(tmp_path, text, line):
    assert f"line {line}" in refusal(written(tmp_path, "bad.obj", text))


@pytest.mark.parametrize("bad", ["nan", "inf", "-inf", "1e200"])
def test_a_coordinate_out_of_reach_is_refused_by_place(tmp_path, bad):
    path = written(tmp_path, "bad.obj", OBJ.replace("v 1 0 0", f"v 1 {bad} 0"))
    with pytest.raises(DirichletError, match=r"line 2|vertex 1"):
        read_mesh(path)


def test_a_ply_text_file_is_read(tmp_path):
    assert read_mesh(written(tmp_path, "fine.ply", PLY)).face_count == 1


@pytest.mark.parametrize(("vertices", "faces"), [(10**11, 1), (3, 10**11), (4, 1), (3, 2), (-1, 1), ("many", 1)])
def test_a_header_that_promises_too_much_is_refused_without_the_memory(tmp_path, vertices, faces):
    lie = PLY.replace("vertex 3", f"vertex {vertices}").replace("face 1", f"face {faces}")
    refusal(written(tmp_path, "greedy.ply", lie))


@pytest.mark.parametrize("ending", [".ply", ".off", ".stl"])
def test_a_truncated_file_is_refused(tmp_path, ending):
    whole = tmp_path / f"whole{ending}"
    write_mesh(whole, sphere(5, 7).mesh())
    content = whole.read_bytes()
    for share in (0.1, 0.5, 0.9):
        refusal(written(tmp_path, f"cut{ending}", content[: int(share * len(content))]))


def test_a_file_of_the_wrong_byte_order_is_refused(tmp_path):
    write_mesh(tmp_path / "fine.ply", sphere(5, 7).mesh())
    content = (tmp_path / "fine.ply").read_bytes()
    assert content.count(b"binary_little_endian") == 1
    refusal(written(tmp_path, "swapped.ply", content.replace(b"binary_little_endian", b"binary_big_endian")))


def test_a_refused_write_leaves_what_was_there(tmp_path):
    path = written(tmp_path, "mesh.off", "precious")
    with pytest.raises(DirichletError):
        write_mesh(path, sphere(5, 7).mesh(), colors=np.zeros((37, 3), np.uint8))
    with pytest.raises(DirichletError):
        write_mesh(tmp_path / "mesh.xyz", sphere(5, 7).mesh())
    with pytest.raises(DirichletError):
        write_mesh(tmp_path / "nowhere" / "mesh.obj", sphere(5, 7).mesh())
    assert path.read_text() == "precious"
    assert [entry.name for entry in tmp_path.iterdir()] == ["mesh.off"]


@pytest.mark.parametrize("colors", [np.zeros((36, 3)), np.full((37, 3), 256), np.full((37, 3), -1), "red"])
def test_colours_that_do_not_fit_are_refused(tmp_path, colors):
    with pytest.raises(DirichletError):
        write_mesh(tmp_path / "mesh.ply", sphere(5, 7).mesh(), colors=colors)
    assert not list(tmp_path.iterdir())
