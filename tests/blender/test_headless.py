# SPDX-License-Identifier: GPL-3.0-or-later
"""solve_isolines.py in a Blender of its own: the operators' results, or one sentence and nothing written."""

import json

import bpy
import numpy as np
import pytest
from in_new_blender import run_script, save
from scene import add, field_of, grid, painted_grid, painted_sphere

SCRIPT = "solve_isolines.py"


def splines(obj):
    """Points of every isoline of the object, one array."""
    curve = obj.dirichlet.isolines.data
    return np.array([tuple(point.co) for spline in curve.splines for point in spline.points])


def test_saved_field_and_lines_equal_the_operators(tmp_path):
    obj = painted_sphere()
    source = save(tmp_path)
    obj.dirichlet.count = 7
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    field, lines = field_of(obj), splines(obj)

    done = run_script(
        SCRIPT, "--object", "Sphere", "--isolines", 7, "--save", tmp_path / "out.blend",
        "--out-field", tmp_path / "field.npy", "--out-lines", tmp_path / "lines.json", "--report", tmp_path / "r.json",
        file=source,
    )  # fmt: skip

    assert (done.returncode, done.stderr) == (0, "")
    assert np.array_equal(np.load(tmp_path / "field.npy").astype(np.float32), field)
    assert len(json.loads((tmp_path / "lines.json").read_text())["lines"]) == 7
    assert [patch["name"] for patch in json.loads((tmp_path / "r.json").read_text())["patches"]] == ["bottom", "top"]
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "out.blend"))
    saved = bpy.data.objects["Sphere"]
    assert np.array_equal(field_of(saved), field)
    assert np.array_equal(splines(saved), lines)


def test_groups_named_take_the_place_of_the_list(tmp_path):
    painted_grid()
    done = run_script(
        SCRIPT, "--group", "left=-1", "--group", "right=5", "--isolines", 2, "--out-field", tmp_path / "f.npy",
        file=save(tmp_path),
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    across = np.load(tmp_path / "f.npy").reshape(7, 12)
    assert np.allclose(across, np.linspace(-1, 5, 12), atol=1e-12)


@pytest.mark.parametrize(
    ("words", "taken"),
    [([], "polygon"), (["--laplacian", "cotangent"], "cotangent"), (["--laplacian", "auto"], "polygon")],
)
def test_the_laplacian_is_the_objects_unless_one_is_named(tmp_path, words, taken):
    painted_grid().dirichlet.laplacian = "polygon"
    done = run_script(SCRIPT, *words, "--report", tmp_path / "r.json", file=save(tmp_path))
    assert done.returncode == 0, done.stderr
    assert json.loads((tmp_path / "r.json").read_text())["solve"]["laplacian"] == taken
    assert ("laplacian: polygon, as " in done.stdout) == ("auto" in words)


def test_patches_join_the_groups_named(tmp_path):
    painted_grid()
    done = run_script(
        SCRIPT, "--group", "left=0.1", "--patch", "corner=0.1@0,0,0,0.1", "--patch", f"ids=1.2@{tmp_path / 'ids'}",
        "--out-field", tmp_path / "f.npy", file=ids_of_the_right_column(tmp_path),
    )  # fmt: skip
    assert done.returncode == 0, done.stderr  # the corner is in two patches, which agree
    across = np.load(tmp_path / "f.npy").reshape(7, 12)
    assert np.allclose(across, np.linspace(0.1, 1.2, 12), atol=1e-7)


def ids_of_the_right_column(folder):
    (folder / "ids").write_text(" ".join(str(12 * row + 11) for row in range(7)))
    return save(folder)


def test_a_mesh_file_is_solved_and_rendered(tmp_path):
    (tmp_path / "square.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 .1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"
    )
    done = run_script(
        SCRIPT, tmp_path / "square.obj", "--patch", "low=0@0,0,0,0.1", "--patch", "high=1@1,1,0,0.1", "--isolines", 3,
        "--render", tmp_path / "out.png", "--size", 32, 24,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    image = bpy.data.images.load(str(tmp_path / "out.png"))
    pixels = np.array(image.pixels[:]).reshape(24, 32, 4)
    assert tuple(image.size) == (32, 24)
    assert np.ptp(pixels[..., :3], axis=2).max() > 0.5  # coloured somewhere
    assert (pixels[0, 0] == 1).all()  # on white


def test_a_picture_shows_lines_whatever_the_output_of_the_object(tmp_path):
    painted_grid().dirichlet.output = "MESH"
    words = ("--isolines", 3, "--render", tmp_path / "out.png", "--size", 32, 24, "--save", tmp_path / "out.blend")
    done = run_script(SCRIPT, *words, file=save(tmp_path))
    assert done.returncode == 0, done.stderr
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "out.blend"))
    assert len(bpy.data.objects["Grid"].dirichlet.isolines.data.splines) == 3


def two_objects():
    painted_grid(name="First")
    grid(name="Second")


def no_faces():
    add([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], "Grid")


REFUSALS = {
    "object": (painted_grid, ["--object", "Nobody"], "there is no mesh object 'Nobody'"),
    "several objects": (two_objects, [], "--object"),
    "group": (painted_grid, ["--group", "north=1"], "no vertex group 'north'"),
    "no patch": (grid, [], "nothing is painted"),
    "empty patch": (grid, ["--patch", "far=1@100,0,0,1"], "far"),
    "vertex outside": (grid, ["--patch", "ids=1@{folder}/ids.txt"], "99999"),
    "mesh file": (grid, ["{folder}/nothing.obj"], "nothing.obj"),
    "file of vertices": (grid, ["--patch", "ids=1@{folder}/nothing.txt"], "nothing.txt"),
    "group without value": (painted_grid, ["--group", "left"], "'left' is not NAME=VALUE"),
    "value not finite": (painted_grid, ["--group", "left=nan"], "left"),
    "no levels": (painted_grid, ["--isolines", "-1"], "-1"),
    "no faces": (no_faces, [], "no faces"),
    "ending": (painted_grid, ["--render", "{folder}/out.gif"], "does not end in .png"),
    "infinite value": (painted_grid, ["--group", "left=inf"], "'left' has the value inf, which is beyond"),
    "value too large": (painted_grid, ["--group", "left=1e300"], "'left' has the value 1e+300, which is beyond"),
    "patch too large": (grid, ["--patch", "all=-1e39@0,0,0,99"], "'all' has the value -1e+39, which is beyond"),
    "folder": (painted_grid, ["--out-lines", "{folder}/missing/lines.json"], "missing"),
    "folder of the picture": (painted_grid, ["--render", "{folder}/missing/x.png"], "no folder"),
    "picture under a file": (painted_grid, ["--render", "{folder}/ids.txt/x.png"], "no folder"),
    "picture": (painted_grid, ["--render", "/proc/x.png", "--size", "16", "16"], "cannot write '/proc/x.png'"),
    "size": (painted_grid, ["--size", "0", "10"], "pixels"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSALS)
def test_refused_in_one_sentence_with_nothing_written(case, tmp_path):
    make, words, named = REFUSALS[case]
    make()
    (tmp_path / "ids.txt").write_text("0 99999")
    source = save(tmp_path)
    before = sorted(tmp_path.iterdir())
    words = [word.format(folder=tmp_path, name=tmp_path.name) for word in words]
    outputs = ["--save", tmp_path / "out.blend", "--report", tmp_path / "report.json"]
    done = run_script(SCRIPT, *outputs, *words, file=source)
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert named in done.stderr
    assert "Traceback" not in done.stdout
    assert sorted(tmp_path.iterdir()) == before
