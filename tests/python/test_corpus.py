# SPDX-License-Identifier: GPL-3.0-or-later
"""`./run corpus`: every mesh, painting and Laplacian is tried, and what fails, crashes or hangs is told and counted."""

import os
import sys
import time
from pathlib import Path

import pytest
from dirichlet_surface import LAPLACIANS, write_mesh
from mesh_makers import ZOO
from test_real_meshes import SMALL

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "corpus"))

import cases
import corpus
import isolation

ROWS = len(LAPLACIANS)
CASES = ROWS * len(cases.PAINTINGS)


@pytest.fixture(autouse=True)
def path_of_workers(monkeypatch, package_path):
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([package_path, *sys.path]))


def run(capsys, *places) -> tuple[int, str]:
    code = corpus.main(list(map(str, places)))
    return code, capsys.readouterr().out


def test_every_mesh_of_a_folder_is_tried_with_every_painting_and_laplacian(tmp_path, capsys):
    (tmp_path / "below").mkdir()
    for number, soup in enumerate(ZOO.values()):
        write_mesh(tmp_path / f"below/mesh {number}{('.obj', '.ply', '.off')[number % 3]}", soup.mesh())
    (tmp_path / "scene.gltf").write_text("{}")
    table = tmp_path / "tables" / "table.txt"
    code, text = run(capsys, tmp_path, "--table", table)
    assert code == 0, text
    assert f"{len(ZOO)} meshes, {CASES * len(ZOO)} cases: {CASES * len(ZOO)} passed, 0 refused, 0 failed" in text
    assert "Not readable\n  scene.gltf: " in text
    assert sum(line.startswith("mesh ") and " passed " in line for line in text.splitlines()) == ROWS * len(ZOO)
    assert table.read_text(encoding="utf-8") == text


def test_a_clear_refusal_is_none_of_the_failures(tmp_path, capsys):
    (tmp_path / "broken.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    code, text = run(capsys, tmp_path / "broken.off")
    assert code == 0, text
    assert f"0 passed, {CASES} refused, 0 failed" in text
    assert "broken.off" in text.split("Refused")[1]
    assert "line 6" in text.split("Refused")[1]


def test_a_wrong_result_is_told_with_what_is_wrong(tmp_path, monkeypatch):
    write_mesh(tmp_path / "grid.obj", ZOO["triangle grid"].mesh())
    solve = cases.solve

    def wrong_by_one(mesh, vertices, values, laplacian):
        field = solve(mesh, vertices, values, laplacian=laplacian)
        field.values[-1 if vertices[-1] != mesh.vertex_count - 1 else 20] += 1
        return field

    monkeypatch.setattr(cases, "solve", wrong_by_one)
    outcome = cases.check(cases.Case(tmp_path / "grid.obj", "graph", "eight vertices"))
    assert (outcome.status, outcome.outside) == ("failed", 1)
    assert "1 values lie outside the painted range" in outcome.why


def crash_hang_or_double(case: str | int) -> int:
    if case == "crash":
        os.abort()
    if case == "hang":
        time.sleep(600)
    return 2 * int(case)


def test_a_case_that_crashes_or_hangs_takes_no_other_along():
    given = [1, "crash", 2, "hang", 3]
    results = list(isolation.results(crash_hang_or_double, given, lambda case: 3 if case == "hang" else 60))
    assert [str(result) for result in results] == ["2", "crashed: SIGABRT", "4", "no result within 3 s", "6"]


def test_no_mesh_at_all_is_an_error(tmp_path, capsys):
    assert run(capsys, tmp_path)[0] == 2


def test_small_real_meshes_pass(real_mesh_folder, capsys):
    code, text = run(capsys, *(real_mesh_folder / name for name in SMALL))
    assert code == 0, text
    assert "0 failed" in text
