# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh file has the same field through Blender's importers as through ours; a damaged one is named with its line."""

import struct
import sys

import bpy
import numpy as np
import pytest
from archives import ROOT
from in_new_blender import run_script
from scene import field_of, paint

pytest.importorskip("scipy", reason="the Python tests' meshes come with it")

from hostile import ZOO

sys.path.append(str(ROOT / "blender_scripts"))
from mesh_object import add_mesh_object


def import_with_blender(path):
    """The object that Blender's own importer makes of the file, whatever it is called in this version."""
    kind = path.suffix[1:]
    before = set(bpy.data.objects)
    if f"{kind}_import" in dir(bpy.ops.wm):
        getattr(bpy.ops.wm, f"{kind}_import")(filepath=str(path))
    else:
        getattr(bpy.ops.import_mesh, kind)(filepath=str(path))
    (obj,) = set(bpy.data.objects) - before
    return obj


def solve_from_end_to_end(pipeline, obj):
    """Positions (V, 3) in the file's axes, and the field between the first and the last vertex by coordinates."""
    positions = np.empty((len(obj.data.vertices), 3), np.float32)
    obj.data.vertices.foreach_get("co", positions.ravel())
    order = np.lexsort(positions.T)
    paint(obj, "first", order[:1], 0.0)
    paint(obj, "last", order[-1:], 1.0)
    pipeline.solve_field(obj)
    return positions[order], field_of(obj)[order]


@pytest.mark.parametrize("kind", ["obj", "ply", "stl"])
@pytest.mark.parametrize(
    "name", ["triangle grid", "quad cylinder", "sphere", "Klein bottle", "prism", "book of five pages", "bow tie"]
)
def test_both_ways_give_the_same_field(surface, pipeline, tmp_path, name, kind):
    path = tmp_path / f"mesh.{kind}"
    surface.write_mesh(path, ZOO[name].mesh())
    ours = solve_from_end_to_end(pipeline, add_mesh_object(surface.read_mesh(path), "Ours"))
    theirs = solve_from_end_to_end(pipeline, import_with_blender(path))
    assert np.array_equal(ours[0], theirs[0])
    assert np.allclose(ours[1], theirs[1], rtol=0, atol=1e-6)


@pytest.mark.parametrize("kind", ["obj", "ply"])
def test_a_face_that_is_there_twice_makes_no_difference(surface, pipeline, tmp_path, kind):
    """Some of Blender's importers drop one of them without a word."""
    path, soup = tmp_path / f"twice.{kind}", ZOO["quad grid"]
    surface.write_mesh(path, type(soup)(soup.positions, [*soup.faces, soup.faces[3]]).mesh())
    ours, theirs = add_mesh_object(surface.read_mesh(path), "Ours"), import_with_blender(path)
    assert len(ours.data.polygons) == len(soup.faces) + 1
    fields = [solve_from_end_to_end(pipeline, obj)[1] for obj in (ours, theirs)]
    assert np.allclose(*fields, rtol=0, atol=1e-6)


DAMAGED = {
    "empty.obj": (b"", "empty.obj"),
    "text.obj": (b"v 0 0 0\nv 1 0 0\nv 0 one 0\nf 1 2 3\n", "text.obj, line 3"),
    "beyond.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "beyond.obj, line 4"),
    "short.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "short.obj, line 4"),
    "nan.obj": (b"v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "nan.obj, line 2"),
    "promises.ply": (
        b"ply\nformat binary_little_endian 1.0\nelement vertex 100000000000\nproperty float x\nproperty float y\n"
        b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + bytes(24),
        "promises.ply",
    ),
    "cut.stl": (bytes(80) + struct.pack("<I", 1000) + bytes(50), "cut.stl"),
    "mesh.fbx": (b"Kaydara", "mesh.fbx"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_file_is_refused_with_the_place(tmp_path, name):
    content, place = DAMAGED[name]
    (tmp_path / name).write_bytes(content)
    done = run_script(
        "solve_isolines.py", tmp_path / name, "--patch", "all=0@0,0,0,9", "--save", tmp_path / "out.blend"
    )
    assert done.returncode == 2
    assert place in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    assert "Traceback" not in done.stdout
    assert [path.name for path in tmp_path.iterdir()] == [name]
