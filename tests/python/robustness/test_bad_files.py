# SPDX-License-Identifier: GPL-3.0-or-later
"""A file that is damaged or lies is refused with its line or byte, and costs no more memory than it has bytes."""

import json
import os
import re
import struct

import numpy as np
import pytest
from dirichlet_surface import read_mesh, write_mesh
from file_texts import OBJ, WHOLE, binary_ply, binary_stl
from mesh_makers import sphere
from outcomes import refusal


def read(folder, name: str, content: str | bytes):
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_mesh(path)


def refused(folder, name: str, content: str | bytes) -> str:
    """The sentence, which names the file and a line or byte of it."""
    message = refusal(read, folder, name, content)
    assert re.search(rf"{re.escape(name)}, (line|byte) \d+: ", message), message
    return message


@pytest.fixture
def little_memory():
    """Room for 300 MB more."""
    resource = pytest.importorskip("resource")
    with open("/proc/self/statm") as file:
        used = int(file.read().split()[0]) * resource.getpagesize()
    limits = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + 300_000_000, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_AS, limits)


@pytest.mark.parametrize("kind", WHOLE)
def test_the_files_that_are_damaged_below_are_whole(tmp_path, kind):
    assert read(tmp_path, f"mesh.{kind}", WHOLE[kind]).face_count == 1


@pytest.mark.parametrize("lie", [10**11, 10**9, 2**32 - 1, 2**63 - 1, 2**64])
@pytest.mark.parametrize(
    ("kind", "true"),
    [
        ("ply", "vertex 3"),
        ("ply", "face 1"),
        ("ply", "\n3 0"),
        ("off", "3 1 0"),
        ("off", " 1 0\n0"),
        ("off", "\n3 0 1"),
    ],
)
def test_a_count_that_the_file_cannot_hold_is_refused_at_its_line(tmp_path, little_memory, kind, true, lie):
    assert WHOLE[kind].count(true) == 1
    false = re.sub(r"\d+", str(lie), true, count=1)
    assert "line" in refused(tmp_path, f"greedy.{kind}", WHOLE[kind].replace(true, false))


@pytest.mark.parametrize("lie", [10**9, 2**32 - 1])
def test_a_count_in_a_binary_file_is_refused_at_its_byte(tmp_path, little_memory, lie):
    face = struct.pack("<I3i", lie, 0, 1, 2)
    for kind, content in {"stl": binary_stl(lie), "ply": binary_ply(corners=face)}.items():
        message = refused(tmp_path, f"greedy.{kind}", content)
        assert str(lie) in message
        assert "byte" in message


@pytest.mark.parametrize("lie", [-1, "many", 1.5, ""])
@pytest.mark.parametrize(("kind", "true"), [("ply", "vertex 3"), ("ply", "face 1"), ("off", "3 1 0")])
def test_a_count_that_is_none_is_refused(tmp_path, kind, true, lie):
    refused(tmp_path, f"odd.{kind}", WHOLE[kind].replace(true, re.sub(r"\d+", str(lie), true, count=1)))


@pytest.mark.parametrize("kind", ["obj", "off", "stl", "ply"])
def test_text_in_place_of_a_number_is_refused_with_line_and_word(tmp_path, kind):
    content = WHOLE[kind].replace("1 0 0", "1 zero 0")
    line = content[: content.index("zero")].count("\n") + 1
    message = refused(tmp_path, f"words.{kind}", content)
    assert f"line {line}: 'zero'" in message


@pytest.mark.parametrize("kind", ["off", "stl", "ply", "little.ply", "big.ply", "binary.stl"])
def test_a_file_cut_anywhere_is_refused(tmp_path, kind):
    whole = WHOLE[kind].encode() if isinstance(WHOLE[kind], str) else WHOLE[kind]
    last = len(whole.rstrip()) if isinstance(WHOLE[kind], str) else len(whole)
    if kind == "stl":
        last = whole.index(b"endsolid") + 1
    for size in range(1, last - 1, 7):
        refused(tmp_path, f"cut.{kind}", whole[:size])


def test_an_obj_file_cut_inside_a_line_or_before_its_faces_is_refused(tmp_path):
    for size in range(1, len(OBJ) - 2):
        assert "cut.obj" in refusal(read, tmp_path, "cut.obj", OBJ[:size])


@pytest.mark.parametrize(("true", "lie"), [("little", "big"), ("big", "little")])
def test_a_header_that_names_the_wrong_byte_order_is_refused(tmp_path, true, lie):
    content = binary_ply(true).replace(f"_{true}_".encode(), f"_{lie}_".encode())
    assert "byte" in refused(tmp_path, "swapped.ply", content)
    path = tmp_path / "sphere.ply"
    write_mesh(path, sphere(5, 7).mesh())
    refused(tmp_path, "sphere.ply", path.read_bytes().replace(b"_little_", b"_big_"))


@pytest.mark.parametrize(
    ("kind", "true", "lie", "line"),
    [
        ("ply", "format ascii", "format ebcdic", 2), ("ply", "format ascii 1.0\n", "", 8), ("ply", "ply", "plt", 1),
        ("ply", "property float x", "property quad x", 4), ("ply", "end_header", "", 10), ("off", "OFF", "4OFF", 1),
        ("off", "OFF", "OFF BINARY", 1), ("stl", "facet", "facette", 2), ("ply", "float z", "float w", 10),
    ],
)  # fmt: skip
def test_a_head_that_is_not_understood_is_refused_by_line(tmp_path, kind, true, lie, line):
    assert f"line {line}:" in refused(tmp_path, f"head.{kind}", WHOLE[kind].replace(true, lie, 1))


@pytest.mark.parametrize("name", ["mesh.xyz", "mesh", "mesh.obj.gz", ".obj"])
def test_an_unknown_format_is_refused_with_the_known_ones(tmp_path, name):
    assert ".obj, .ply, .off and .stl" in refusal(read, tmp_path, name, OBJ)


@pytest.mark.parametrize("kind", ["obj", "off", "stl", "ply"])
def test_an_empty_file_a_folder_and_a_missing_one_are_refused_by_name(tmp_path, kind):
    assert f"nothing.{kind} is empty" in refusal(read, tmp_path, f"nothing.{kind}", "")
    (tmp_path / f"folder.{kind}").mkdir()
    for name in ("folder", "nowhere"):
        assert f"{name}.{kind} cannot be read" in refusal(read_mesh, tmp_path / f"{name}.{kind}")


@pytest.mark.parametrize("kind", ["obj", "off", "stl", "ply"])
def test_binary_garbage_is_refused_in_one_readable_sentence(tmp_path, kind):
    random = np.random.default_rng(0)
    for size in (1, 40, 5000):
        for content in (random.bytes(size), b"\0" * size, WHOLE[kind].encode() + random.bytes(size) + b"\nf 1"):
            message = refusal(read, tmp_path, f"junk.{kind}", content)
            assert message.replace("…", "").isascii()


def test_an_unreadable_file_is_refused_by_name(command, obey_permissions):
    command.write("mesh.obj", OBJ)
    os.chmod("mesh.obj", 0)
    obey_permissions()
    assert "mesh.obj cannot be read: Permission denied" in refusal(read_mesh, "mesh.obj")


def test_a_name_that_is_no_text_is_shown_all_the_same(tmp_path):
    path = os.fsencode(tmp_path) + b"/\xff\xfe.obj"
    assert ".obj cannot be read" in refusal(read_mesh, path)
    with open(path, "w") as file:
        file.write(OBJ)
    assert read_mesh(path).face_count == 1
    assert read_mesh(os.fsdecode(path)).face_count == 1


@pytest.mark.parametrize("kind", WHOLE)
def test_a_damaged_file_is_refused_by_name_and_line_on_the_command_line(command, kind):
    whole = WHOLE[kind]
    damaged = whole[:-3] if isinstance(whole, bytes) else whole.rstrip().rsplit("\n", 2)[0] + "\nf 1 2 nine\n"
    name = command.write(f"damaged.{kind}", damaged)
    message = command.refuses(name, *command.paint("low", 0, [0]), *command.paint("high", 1, [2]))
    assert re.search(rf"damaged\.{re.escape(kind)}, (line|byte) \d+: ", message), message


def test_names_that_are_no_text_are_solved_and_reported(command):
    name = os.fsdecode(b"m\xff.obj")
    command.write(name, OBJ)
    patches = [*command.paint("low", 0.0, [0]), "--patch", os.fsdecode(b"\xff=1@2.txt")]
    command.write("2.txt", "2")
    output = command.accepts(name, *patches, "--report", "report.json", "--out-field", "field.npy")
    assert "m\\udcff.obj" in output
    with open("report.json", encoding="utf-8") as file:
        assert json.load(file)["patches"][1]["name"] == "\udcff"


def test_a_file_may_have_the_longest_name_there_is(tmp_path):
    path = tmp_path / ("a" * 251 + ".obj")
    write_mesh(path, sphere(5, 7).mesh())
    assert read_mesh(path).vertex_count == sphere(5, 7).mesh().vertex_count
