# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m dirichlet_surface`: the API's results in files, or one sentence and nothing written."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from dirichlet_surface import (
    LAPLACIANS,
    even_levels,
    isolines,
    level_through_point,
    read_mesh,
    solve,
    stepped_levels,
    write_mesh,
)
from dirichlet_surface.command_line import main
from dirichlet_surface.patch_argument import parse_patch
from mesh_makers import joined, sphere
from numpy.testing import assert_array_equal

NORTH, SOUTH = "north=1@0,0,1,0.5", "south=0@south.txt"
PAINT = ["--patch", NORTH, "--patch", SOUTH]


@pytest.fixture(autouse=True)
def work_folder(tmp_path, monkeypatch):
    """A folder with a sphere of 110 vertices and a file of its southernmost ones."""
    monkeypatch.chdir(tmp_path)
    write_mesh("sphere.obj", sphere(9, 12).mesh())
    (tmp_path / "south.txt").write_text("109, 108 107\n106\t105,104\r\n")
    return tmp_path


def expected_field() -> tuple:
    mesh = read_mesh("sphere.obj")
    north = np.flatnonzero(np.linalg.norm(mesh.positions - [0, 0, 1], axis=1) <= 0.5)
    vertices, values = np.concatenate((north, np.arange(104, 110))), np.repeat([1.0, 0.0], [len(north), 6])
    return mesh, solve(mesh, vertices, values)


def run(*words: str) -> None:
    assert main(["sphere.obj", *words]) == 0


def levels_of(*words: str) -> np.ndarray:
    run(*PAINT, *words, "--report", "report.json")
    with open("report.json") as file:
        return np.array(json.load(file)["isolines"]["levels"])


def refusal(capfd, *words: str) -> str:
    """The one sentence on stderr, after making sure that nothing else happened."""
    before = sorted(os.listdir())
    try:
        code = main(list(words))
    except SystemExit as stop:  # argparse's way
        code = stop.code
    assert code == 2
    out, err = capfd.readouterr()
    assert out == ""
    assert err.startswith("dirichlet_surface: ")
    assert err.count("\n") == 1
    assert sorted(os.listdir()) == before
    return err


def test_the_module_runs_as_a_command_and_passes_its_exit_code_on(package_path):
    command = [sys.executable, "-m", "dirichlet_surface", "sphere.obj"]
    options = {"env": {**os.environ, "PYTHONPATH": package_path}, "capture_output": True, "text": True}
    fine = subprocess.run([*command, *PAINT, "--out-field", "field.npy"], **options, check=False)
    assert (fine.returncode, fine.stderr) == (0, "")
    assert "110 vertices" in fine.stdout
    assert "wrote field.npy" in fine.stdout
    refused = subprocess.run([*command, "--out-field", "none.npy"], **options, check=False)
    assert (refused.returncode, refused.stdout) == (2, "")
    assert refused.stderr.count("\n") == 1


def test_the_field_is_the_one_of_the_api():
    run(*PAINT, "--out-field", "field.npy")
    assert_array_equal(np.load("field.npy"), expected_field()[1].values)


def test_both_methods_are_at_hand():
    run(*PAINT, "--method", "lscg", "--laplacian", "graph", "--out-field", "field.npy", "--report", "report.json")
    with open("report.json") as file:
        assert json.load(file)["solve"]["method"] == "lscg"
    np.testing.assert_allclose(np.load("field.npy"), expected_field()[1].values, atol=1e-8)


def test_every_laplacian_is_at_hand_and_auto_says_what_it_took(capfd):
    mesh, _ = expected_field()
    north = np.flatnonzero(np.linalg.norm(mesh.positions - [0, 0, 1], axis=1) <= 0.5)
    vertices, values = np.concatenate((north, np.arange(104, 110))), np.repeat([1.0, 0.0], [len(north), 6])
    for laplacian in LAPLACIANS:
        run(*PAINT, "--laplacian", laplacian, "--out-field", "field.npy", "--report", "report.json")
        field = solve(mesh, vertices, values, laplacian=laplacian)
        assert_array_equal(np.load("field.npy"), field.values)
        with open("report.json") as file:
            assert json.load(file)["solve"]["laplacian"] == field.report.laplacian
        said = f"laplacian: {field.report.laplacian}, as {field.report.reason}\n"
        assert (said in capfd.readouterr().out) == (laplacian == "auto")


@pytest.mark.parametrize(
    ("words", "levels"),
    [
        ([], even_levels(0, 1, 10)),
        (["--isolines", "13"], even_levels(0, 1, 13)),
        (["--isolines", "4", "--window", "0.25", "0.5"], even_levels(0.25, 0.5, 4)),
        (["--isolines", "4", "--window", "-1e-1", "0.5"], even_levels(-0.1, 0.5, 4)),
        (["--levels", "0.75,0.125"], [0.75, 0.125]),
        (["--levels", "-0.5,0.5"], [-0.5, 0.5]),
        (["--step", "0.2"], stepped_levels(0, 1, 0.2)),
        (["--step", "0.2", "--phase", "-0.5", "--window", "0", "2"], stepped_levels(0, 2, 0.2, -0.5)),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) and value and isinstance(value[0], str) else None,
)
def test_levels_are_chosen_as_asked(words, levels):
    assert_array_equal(levels_of(*words), levels)


def test_the_level_through_a_point_is_that_of_the_api():
    mesh, field = expected_field()
    assert_array_equal(
        levels_of("--through", "-0.5,0.1,0.2"), [level_through_point(mesh, field.values, [-0.5, 0.1, 0.2])]
    )


def test_a_ball_paints_every_vertex_within_its_radius_and_at_it():
    run("--patch", "up=1@0,0,1,0", "--patch", "down=0@0,0,-1,1.4142135623730951", "--report", "report.json")
    with open("report.json") as file:
        up, down = json.load(file)["patches"]
    assert up["vertices"] == 1
    assert down["vertices"] == 1 + 5 * 12  # the pole, and all rings down to the equator
    assert down["disc"]


def test_a_ball_knows_no_scale():
    positions = sphere(9, 12).positions * 1e-170  # whose squares are 0
    assert_array_equal(parse_patch("pole=1@0,0,1e-170,1e-171").to_patch(positions).vertices, [0])


def test_a_file_of_vertices_may_come_from_another_system(work_folder):
    (work_folder / "south.txt").write_bytes("\ufeff109,108\r\n107, 106\r105 104\r\n".encode())
    run(*PAINT, "--out-field", "field.npy")
    assert_array_equal(np.load("field.npy"), expected_field()[1].values)


def test_overlaps_follow_the_rule():
    overlap = ["--patch", "a=0@south.txt", "--patch", "b=1@south.txt", "--patch", "c=5@0,0,1,0"]
    run(*overlap, "--overlap", "average", "--out-field", "field.npy")
    assert_array_equal(np.load("field.npy")[104:], 0.5)


def test_the_report_holds_everything():
    run(*PAINT, "--patch", "nobody=3@50,0,0,1", "--isolines", "3", "--report", "report.json")
    with open("report.json") as file:
        report = json.load(file)
    mesh, field = expected_field()
    lines = isolines(mesh, field.values, even_levels(0, 1, 3))
    assert report["mesh"] == {
        "vertices": 110, "edges": 324, "faces": 216, "components": 1, "border_loops": 0,
        "repeated_faces": 0, "flat_faces": 0, "crossing_faces": 0, "coincident_vertices": 0,
    }  # fmt: skip
    assert [(patch["name"], patch["value"]) for patch in report["patches"]] == [
        ("north", 1), ("south", 0), ("nobody", 3)
    ]  # fmt: skip
    expected = field.report.to_dict()
    timed = {"seconds"}
    assert {k: v for k, v in report["solve"].items() if k not in timed} == {
        k: v for k, v in expected.items() if k not in timed
    }
    assert set(report["solve"]["seconds"]) == set(expected["seconds"])
    assert report["isolines"]["levels"] == lines.levels.tolist()
    assert (report["isolines"]["lines"], report["isolines"]["closed"], report["isolines"]["open"]) == (3, 3, 0)
    assert report["isolines"]["length"] == lines.length.sum()
    assert len(report["warnings"]) == 1
    assert "'nobody'" in report["warnings"][0]


def test_constant_paint_is_a_warning_without_lines(capfd):
    run("--patch", "a=2@south.txt", "--out-lines", "lines.json")
    with open("lines.json") as file:
        assert json.load(file) == {"levels": [], "lines": []}
    assert "constant" in capfd.readouterr().out


def test_a_piece_without_paint_is_a_warning(capfd):
    write_mesh("two.obj", joined(sphere(9, 12), sphere(3, 4)).mesh())
    assert main(["two.obj", *PAINT, "--out-field", "field.npy", "--out-lines", "lines.json", "--report", "r.json"]) == 0
    assert np.isnan(np.load("field.npy")[110:]).all()
    assert "warning: 14 vertices" in capfd.readouterr().out


def test_two_runs_write_the_same_bytes(work_folder):
    outputs = ["--out-field", "field.ply", "--out-lines", "lines.svg"]
    run(*PAINT, *outputs)
    first = [(work_folder / name).read_bytes() for name in outputs[1::2]]
    run(*PAINT, *outputs)
    assert [(work_folder / name).read_bytes() for name in outputs[1::2]] == first


# --- refusals: one sentence that names the offender, exit code 2, nothing written

OUTPUTS = ["--out-field", "field.npy", "--out-lines", "lines.obj", "--report", "report.json"]


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ([], "MESH"),
        (["sphere.obj", *OUTPUTS], "nothing is painted"),
        (["nowhere.obj", *PAINT, *OUTPUTS], "nowhere.obj"),
        (["south.txt", *PAINT, *OUTPUTS], "south.txt"),
        (["sphere.obj", "--patch", "a=1@nowhere.txt", *OUTPUTS], "nowhere.txt"),
        (["sphere.obj", "--patch", "a=1@.", *OUTPUTS], "'.'"),
        (["sphere.obj", "--patch", "a=1@9,9,9,1", *OUTPUTS], "'a'"),
        (["sphere.obj", "--patch", "a=1", *OUTPUTS], "a=1"),
        (["sphere.obj", "--patch", "a@south.txt", *OUTPUTS], "a@south.txt"),
        (["sphere.obj", "--patch", "=1@south.txt", *OUTPUTS], "=1@south.txt"),
        (["sphere.obj", "--patch", "a=high@south.txt", *OUTPUTS], "high"),
        (["sphere.obj", "--patch", "a=nan@south.txt", *OUTPUTS], "nan"),
        (["sphere.obj", "--patch", "a=1@0,0,1", *OUTPUTS], "0,0,1"),
        (["sphere.obj", "--patch", "a=1@0,0,1,-1", *OUTPUTS], "0,0,1,-1"),
        (["sphere.obj", *PAINT, "--patch", "again=7@south.txt", *OUTPUTS], "'again'"),
        (["sphere.obj", *PAINT, "--overlap", "lowest", *OUTPUTS], "lowest"),
        (["sphere.obj", *PAINT, "--method", "magic", *OUTPUTS], "magic"),
        (["sphere.obj", *PAINT, "--laplacian", "cotan", *OUTPUTS], "cotan"),
        (["sphere.obj", *PAINT, "--isolines", "0", *OUTPUTS], "0"),
        (["sphere.obj", *PAINT, "--isolines", "-3", *OUTPUTS], "-3"),
        (["sphere.obj", *PAINT, "--isolines", "many", *OUTPUTS], "many"),
        (["sphere.obj", *PAINT, "--isolines", "3", "--levels", "0.5", *OUTPUTS], "--levels"),
        (["sphere.obj", *PAINT, "--levels", "0.5,,1", *OUTPUTS], "0.5,,1"),
        (["sphere.obj", *PAINT, "--levels", "nan", *OUTPUTS], "nan"),
        (["sphere.obj", *PAINT, "--levels", "0.5", "--window", "0", "1", *OUTPUTS], "--window"),
        (["sphere.obj", *PAINT, "--window", "1", "0", *OUTPUTS], "window"),
        (["sphere.obj", *PAINT, "--window", "nan", "1", *OUTPUTS], "nan"),
        (["sphere.obj", *PAINT, "--step", "0", *OUTPUTS], "step"),
        (["sphere.obj", *PAINT, "--step", "1e-12", *OUTPUTS], "levels"),
        (["sphere.obj", *PAINT, "--phase", "0.5", *OUTPUTS], "--phase"),
        (["sphere.obj", *PAINT, "--through", "0,0", *OUTPUTS], "0,0"),
        (["sphere.obj", *PAINT, "--through", "0,0,inf", *OUTPUTS], "inf"),
        (["sphere.obj", *PAINT, *OUTPUTS, "--out-field", "field.tiff"], "field.tiff"),
        (["sphere.obj", *PAINT, *OUTPUTS, "--out-lines", "lines"], "lines"),
        (["sphere.obj", *PAINT, *OUTPUTS, "--report", "report.txt"], "report.txt"),
        (["sphere.obj", *PAINT, *OUTPUTS, "--report", "none/report.json"], "none/report.json"),
        (["sphere.obj", *PAINT, *OUTPUTS, "--out-field", "same.csv", "--out-lines", "./same.csv"], "same.csv"),
        (["sphere.obj", *PAINT, *OUTPUTS, "--colour", "red"], "--colour"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else None,
)
def test_a_wrong_command_is_one_sentence_and_writes_nothing(capfd, words, named):
    assert named in refusal(capfd, *words)


@pytest.mark.parametrize(
    ("text", "line", "word"),
    [
        ("1 2\n3 four 5", 2, "four"),
        ("1.5", 1, "1.5"),
        ("\n\n-1", 3, "-1"),
        ("7 99999999999999999999", 1, "99999999999999999999"),
        ("1;2", 1, "1;2"),
        ("0x10", 1, "0x10"),
        ("1,2,\r\n3,+4", 2, "+4"),
    ],
)
def test_a_bad_word_among_vertices_is_named_with_file_and_line(capfd, work_folder, text, line, word):
    (work_folder / "bad.txt").write_bytes(text.encode())
    message = refusal(capfd, "sphere.obj", "--patch", "a=1@bad.txt", *OUTPUTS)
    assert f"'bad.txt', line {line}: '{word}'" in message


def test_a_vertex_outside_the_mesh_is_named_with_its_patch(capfd, work_folder):
    (work_folder / "far.txt").write_text("3 110 111")
    message = refusal(capfd, "sphere.obj", "--patch", "a=1@far.txt", *OUTPUTS)
    assert "patch 'a' has the vertex 110" in message


def test_an_empty_file_of_vertices_is_a_patch_without_vertices(capfd, work_folder):
    (work_folder / "empty.txt").write_text("\n")
    assert "'a' has no vertices" in refusal(capfd, "sphere.obj", "--patch", "a=1@empty.txt", *OUTPUTS)


@pytest.mark.parametrize("blocked", ["field.npy", "lines.obj", "report.json"])
def test_an_output_that_cannot_be_written_leaves_the_others_unwritten(capfd, work_folder, blocked):
    (work_folder / blocked).mkdir()
    assert blocked in refusal(capfd, "sphere.obj", *PAINT, *OUTPUTS)


def test_a_failed_run_keeps_the_results_of_an_earlier_one(capfd, work_folder):
    run(*PAINT, *OUTPUTS)
    capfd.readouterr()
    before = [(work_folder / name).read_bytes() for name in OUTPUTS[1::2]]
    refusal(capfd, "sphere.obj", *PAINT, "--patch", "again=7@south.txt", *OUTPUTS)
    assert [(work_folder / name).read_bytes() for name in OUTPUTS[1::2]] == before
