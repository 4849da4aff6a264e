# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip that Preferences > Add-ons > Install takes, in a Blender with an empty configuration."""

import json
from pathlib import Path

import archives
import bpy
import configuration
import numpy as np
import pytest

USE = """
import bpy, json, sys
obj = bpy.data.objects["Cube"]
bpy.context.view_layer.objects.active = obj
for name, vertices in (("a", [0]), ("b", [7])):
    obj.vertex_groups.new(name=name).add(vertices, 1.0, "REPLACE")
    bpy.ops.dirichlet.patch_add_group(group=name)
bpy.ops.dirichlet.solve_field()
bpy.ops.dirichlet.make_isolines()
obj.dirichlet.isolines.dirichlet_isolines.follow = True
obj.dirichlet.levels_mode = "STEP"
counts = []
for frame, step in ((1, 0.3), (2, 0.15)):
    obj.dirichlet.step = step
    obj.dirichlet.keyframe_insert("step", frame=frame)
for frame in (1, 2):
    bpy.context.scene.frame_set(frame)
    counts.append(len(obj.dirichlet.isolines.data.splines))
print("RESULT", json.dumps({
    "counts": counts,
    "field": [item.value for item in obj.data.attributes["dirichlet_field"].data],
    "closed": list(obj.dirichlet.isolines.data["dirichlet_closed"]),
    "files": [sys.modules[name].__file__ for name in sys.modules if "dirichlet" in name],
}))
"""


@pytest.fixture
def archive(tmp_path):
    return archives.archive_for(bpy.app.binary_path, tmp_path)


def test_installed_zip_stays_enabled_and_its_operators_run(archive, tmp_path, surface):
    home = tmp_path / "configuration"
    environment = configuration.empty(home)
    configuration.install(bpy.app.binary_path, environment, archive)
    printed = configuration.run(bpy.app.binary_path, environment, USE)
    result = json.loads(printed.partition("RESULT")[2].splitlines()[0])
    assert result["files"]
    assert all(home in Path(file).parents for file in result["files"])
    bpy.ops.mesh.primitive_cube_add()
    cube = bpy.context.active_object.data
    mesh = surface.Mesh([tuple(v.co) for v in cube.vertices], np.array([tuple(p.vertices) for p in cube.polygons]))
    expected = surface.solve(mesh, [0, 7], [0, 1]).values.astype(np.float32)
    assert result["field"] == expected.tolist()
    assert result["counts"][0] < result["counts"][1]  # handlers are there: lines follow the frame
    assert result["closed"]
    assert all(result["closed"])
