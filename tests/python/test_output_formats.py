# SPDX-License-Identifier: GPL-3.0-or-later
"""Every output format, read back and compared with the arrays."""

import json
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from dirichlet_surface import InputError, isolines, read_mesh, solve
from dirichlet_surface.output import FIELD_WRITERS, LINE_WRITERS, write_all
from dirichlet_surface.ramps import UNDEFINED_COLOR, apply_ramp, srgb_bytes
from mesh_makers import Soup, grid, joined, sphere
from numpy.testing import assert_allclose, assert_array_equal

SOUP = joined(sphere(9, 12), grid(5, 4), sphere(3, 4))  # closed lines, open lines, no paint
MESH = SOUP.mesh()
FIELD = solve(MESH, [0, 109, 110, 139], [0.0, 1.0, -0.25, 1.3])
LINES = isolines(MESH, FIELD.values, [0.9, 0.3, 0.5])
SVG = "{http://www.w3.org/2000/svg}"


def written_field(folder, ending):
    FIELD_WRITERS[ending](MESH, FIELD, folder / f"field{ending}")
    return folder / f"field{ending}"


def written_lines(folder, ending, lines=LINES, mesh=MESH):
    LINE_WRITERS[ending](mesh, lines, folder / f"lines{ending}")
    return folder / f"lines{ending}"


def test_the_field_in_npy_has_every_bit(tmp_path):
    assert_array_equal(np.load(written_field(tmp_path, ".npy")), FIELD.values)


def test_the_field_in_csv_has_every_bit(tmp_path):
    table = np.genfromtxt(written_field(tmp_path, ".csv"), delimiter=",", names=True)
    assert table.dtype.names == ("vertex", "x", "y", "z", "value")
    assert_array_equal(table["vertex"], np.arange(SOUP.size))
    assert_array_equal(np.column_stack((table["x"], table["y"], table["z"])), SOUP.positions)
    assert_array_equal(table["value"], FIELD.values)


def test_the_field_in_ply_is_the_mesh_with_the_ramps_colours(tmp_path):
    path = written_field(tmp_path, ".ply")
    back = read_mesh(path)
    assert_allclose(back.positions, SOUP.positions, atol=1e-6)
    assert_array_equal(back.corners, MESH.corners)
    colors = ply_colors(path)
    assert_array_equal(colors, srgb_bytes(apply_ramp(FIELD.values, -0.25, 1.3)))
    assert_array_equal(np.unique(colors[140:], axis=0), [srgb_bytes(np.array(UNDEFINED_COLOR))])


def ply_colors(path) -> np.ndarray:
    """(V, 3) bytes of a little-endian binary PLY file."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    text = header.decode().splitlines()
    assert "format binary_little_endian 1.0" in text
    place = next(number for number, line in enumerate(text) if line.startswith("element vertex"))
    types = {"float": "<f4", "double": "<f8", "uchar": "u1", "uint8": "u1", "float32": "<f4", "float64": "<f8"}
    fields = []
    for line in text[place + 1 :]:
        if not line.startswith("property"):
            break
        _, kind, name = line.split()
        fields.append((name, types[kind]))
    rows = np.frombuffer(body, dtype=fields, count=int(text[place].split()[2]))
    return np.column_stack([rows[name] for name in ("red", "green", "blue")])


def test_lines_in_json_have_every_bit(tmp_path):
    with open(written_lines(tmp_path, ".json")) as file:
        content = json.load(file)
    assert content["levels"] == [0.9, 0.3, 0.5]
    assert len(content["lines"]) == len(LINES)
    for number, line in enumerate(content["lines"]):
        part = slice(LINES.offsets[number], LINES.offsets[number + 1])
        assert set(line) == {"level", "value", "closed", "length", "points", "edges", "t"}
        assert (line["level"], line["closed"], line["length"]) == (
            LINES.level[number], LINES.closed[number], LINES.length[number]
        )  # fmt: skip
        assert line["value"] == LINES.levels[line["level"]]
        for name in ("points", "edges", "t"):
            assert_array_equal(line[name], getattr(LINES, name)[part])


def test_lines_in_csv_have_every_bit(tmp_path):
    table = np.genfromtxt(written_lines(tmp_path, ".csv"), delimiter=",", names=True)
    line = np.repeat(np.arange(len(LINES)), np.diff(LINES.offsets))
    assert_array_equal(table["line"], line)
    assert_array_equal(table["level"], LINES.level[line])
    assert_array_equal(table["value"], LINES.levels[LINES.level[line]])
    assert_array_equal(table["closed"], LINES.closed[line])
    assert_array_equal(np.column_stack((table["x"], table["y"], table["z"])), LINES.points)
    assert_array_equal(np.column_stack((table["edge_first"], table["edge_second"])), LINES.edges)
    assert_array_equal(table["t"], LINES.t)


def test_lines_in_obj_are_polylines_that_close_where_they_should(tmp_path):
    rows = [row.split() for row in written_lines(tmp_path, ".obj").read_text().splitlines()]
    assert_array_equal([list(map(float, row[1:])) for row in rows if row[0] == "v"], LINES.points)
    assert [row[1] for row in rows if row[0] == "g"] == [f"level_{level}" for level in LINES.level]
    polylines = [list(map(int, row[1:])) for row in rows if row[0] == "l"]
    assert len(polylines) == len(LINES)
    for number, polyline in enumerate(polylines):
        expected = list(range(LINES.offsets[number] + 1, LINES.offsets[number + 1] + 1))
        assert polyline == expected + expected[:1] * bool(LINES.closed[number])


def test_lines_in_svg_are_the_projection_along_the_thinnest_axis(tmp_path):
    root = ElementTree.parse(written_lines(tmp_path, ".svg")).getroot()
    thinnest = np.argmin(np.ptp(SOUP.positions, axis=0))
    assert f"along the {'xyz'[thinnest]} axis" in root.find(SVG + "desc").text
    elements = [element for element in root.iter() if element.get("points")]
    assert [element.tag == SVG + "polygon" for element in elements] == LINES.closed.tolist()
    right, up = np.delete(np.arange(3), thinnest)
    low, high = SOUP.positions.min(axis=0), SOUP.positions.max(axis=0)
    scale = 1000 / max(np.ptp(SOUP.positions, axis=0)[[right, up]])
    for number, element in enumerate(elements):
        points = np.array([list(map(float, pair.split(","))) for pair in element.get("points").split()])
        expected = np.column_stack((LINES.line(number)[:, right] - low[right], high[up] - LINES.line(number)[:, up]))
        assert_allclose(points, scale * expected, atol=0.006)
        assert element.get("class") == f"level-{LINES.level[number]}"


def test_lines_in_svg_are_coloured_by_level(tmp_path):
    root = ElementTree.parse(written_lines(tmp_path, ".svg")).getroot()
    colors = srgb_bytes(apply_ramp(LINES.levels, 0.3, 0.9))
    drawn = [element.get("stroke") for element in root.iter() if element.get("points")]
    assert drawn == ["#" + bytes(colors[level]).hex() for level in LINES.level]
    assert len(set(drawn)) == 3


@pytest.mark.parametrize("turn", [0, 1, 2])
def test_the_svg_view_is_not_mirrored(tmp_path, turn):
    """A square in the plane, outside towards the viewer, turned by its field: higher values stay on the left."""
    soup = grid(6, 5)
    axes = [[0, 1, 2], [2, 0, 1], [0, 2, 1]][turn]
    positions = soup.positions[:, axes] * [1, 1, 1]
    if turn == 2:
        positions[:, 1] *= -1  # +z becomes -y
    mesh = Soup(positions, soup.faces).mesh()
    lines = isolines(mesh, soup.positions[:, 0], [2.5])
    root = ElementTree.parse(written_lines(tmp_path, ".svg", lines, mesh)).getroot()
    points = [pair.split(",") for pair in next(e for e in root.iter() if e.get("points")).get("points").split()]
    (x0, y0), (x1, y1) = np.array([points[0], points[-1]], float)
    across = np.array([y1 - y0, -(x1 - x0)])  # left of the direction, y running down
    assert across @ step_of_growing_values(mesh, soup) > 0


def step_of_growing_values(mesh, soup) -> np.ndarray:
    thinnest = int(np.argmin(np.ptp(mesh.positions, axis=0)))
    right, up = np.delete(np.arange(3), thinnest)
    step = mesh.positions[1] - mesh.positions[0]  # vertex 1 has the higher value
    return np.array([step[right], -step[up]])


@pytest.mark.parametrize("ending", LINE_WRITERS)
def test_no_lines_are_a_valid_file_too(tmp_path, ending):
    path = written_lines(tmp_path, ending, isolines(MESH, FIELD.values, []))
    if ending == ".svg":
        assert ElementTree.parse(path).getroot().tag == SVG + "svg"
    elif ending == ".json":
        assert json.loads(path.read_text()) == {"levels": [], "lines": []}
    else:
        assert len(path.read_text().splitlines()) == (ending == ".csv")


def test_writing_is_all_or_nothing(tmp_path):
    def fine(path):
        path.write_text("new")

    def broken(path):
        path.write_text("half")
        raise OSError(28, "No space left on device")

    (tmp_path / "first.txt").write_text("old")
    with pytest.raises(InputError, match=r"cannot write '.*second.txt': No space left on device"):
        write_all([(tmp_path / "first.txt", fine), (tmp_path / "second.txt", broken)])
    assert [path.name for path in tmp_path.iterdir()] == ["first.txt"]
    assert (tmp_path / "first.txt").read_text() == "old"
    write_all([(tmp_path / "first.txt", fine), (tmp_path / "second.txt", fine)])
    assert sorted(path.read_text() for path in tmp_path.iterdir()) == ["new", "new"]


@pytest.mark.parametrize("parent", ["missing", "file.txt"])
def test_a_missing_folder_is_named_before_any_writer_runs(tmp_path, parent):
    (tmp_path / "file.txt").write_text("old")
    with pytest.raises(InputError, match=rf"cannot write '.*x.png': there is no folder '.*{parent}'"):
        write_all([(tmp_path / "first.txt", pytest.fail), (tmp_path / parent / "x.png", pytest.fail)])
    assert [path.name for path in tmp_path.iterdir()] == ["file.txt"]


def test_a_name_as_long_as_names_may_be_can_be_written(tmp_path):
    path = tmp_path / ("x" * 251 + ".txt")
    write_all([(path, lambda beside: beside.write_text("new"))])
    assert path.read_text() == "new"


def test_an_error_of_any_kind_leaves_no_temporary_file(tmp_path):
    def broken(path):
        path.write_text("half")
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        write_all([(tmp_path / "file.txt", broken)])
    assert not list(tmp_path.iterdir())
