# SPDX-License-Identifier: GPL-3.0-or-later
"""What is odd but legal works, through the library and on the command line."""

import numpy as np
import pytest
from dirichlet_surface import Mesh, read_mesh
from dirichlet_surface.field import LAPLACIANS
from file_texts import OBJ, OFF, PLY, STL
from mesh_makers import grid, prism
from outcomes import obj_of, solved

TEXTS = {"obj": OBJ, "off": OFF, "ply": PLY, "stl": STL}
BOM = b"\xef\xbb\xbf"


def written(path, content: bytes) -> Mesh:
    path.write_bytes(content)
    return read_mesh(path)


@pytest.mark.parametrize("kind", TEXTS)
@pytest.mark.parametrize("end", [b"\n", b"\r\n", b"\r"], ids=["LF", "CRLF", "CR"])
@pytest.mark.parametrize("mark", [b"", BOM], ids=["bare", "BOM"])
def test_line_ends_and_a_byte_order_mark_make_no_difference(tmp_path, kind, end, mark):
    mesh = written(tmp_path / f"mesh.{kind}", mark + TEXTS[kind].encode().replace(b"\n", end))
    np.testing.assert_array_equal(mesh.positions, [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    np.testing.assert_array_equal(mesh.corners, [0, 1, 2])


@pytest.mark.parametrize(
    "face", ["f -3 -2 -1", "f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1 2 3 3", "f 1 1 2 3", "f 1 \\\n2 3", "f 1 2 3 #!"]
)
def test_an_obj_face_may_be_written_in_many_ways(tmp_path, face):
    mesh = written(tmp_path / "mesh.obj", (OBJ.replace("f 1 2 3", face) + "vt 0 0\n" * 3).encode())
    np.testing.assert_array_equal(mesh.corners, [0, 1, 2])


def test_obj_faces_may_come_before_their_vertices(tmp_path):
    vertices, face = OBJ[: OBJ.index("f")], OBJ[OBJ.index("f") :]
    assert written(tmp_path / "mesh.obj", (face + vertices).encode()).vertex_count == 3


def test_comments_blank_lines_and_lone_vertices_are_passed_over(tmp_path):
    content = "# a comment\n\n" + OBJ.replace("f 1", "v 9 9 9\n\n# another\nf 1")
    assert written(tmp_path / "mesh.obj", content.encode()).vertex_count == 4


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_polygon_of_five_thousand_corners_is_solved(laplacian):
    field, lines = solved(prism(5000).mesh(), [0, 5000], [0.0, 1.0], laplacian)
    assert field.report.undefined == 0
    assert lines.closed.all()


def test_a_polygon_of_five_thousand_corners_is_solved_on_the_command_line(command):
    mesh = command.write("mesh.obj", obj_of(prism(5000)))
    output = command.accepts(mesh, *command.paint("low", 0, [0]), *command.paint("high", 1, [5000]))
    assert "0 open" in output


@pytest.mark.parametrize("laplacian", LAPLACIANS)
def test_a_quad_with_a_corner_said_twice_is_the_triangle(laplacian):
    positions = grid(1, 1).positions
    quads, triangles = Mesh(positions, [[0, 1, 3, 3], [0, 0, 3, 2]]), grid(1, 1).mesh()
    fields = [solved(mesh, [0, 1], [0.0, 1.0], laplacian)[0].values for mesh in (quads, triangles)]
    np.testing.assert_array_equal(*fields)
