# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip that Preferences > Add-ons > Install takes, in a Blender with an empty configuration."""

import json
import os
import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from conftest import ROOT, STAGED

INSTALL = """
import bpy
bpy.ops.preferences.addon_install(filepath={archive!r})
bpy.ops.preferences.addon_enable(module="dirichlet_isolines")
bpy.ops.wm.save_userpref()
"""

USE = """
import bpy, json, sys
obj = bpy.data.objects["Cube"]
bpy.context.view_layer.objects.active = obj
for name, vertices in (("a", [0]), ("b", [7])):
    obj.vertex_groups.new(name=name).add(vertices, 1.0, "REPLACE")
    bpy.ops.dirichlet.patch_add_group(group=name)
bpy.ops.dirichlet.solve_field()
bpy.ops.dirichlet.make_isolines()
print("RESULT", json.dumps({
    "field": [item.value for item in obj.data.attributes["dirichlet_field"].data],
    "closed": list(obj.dirichlet.isolines.data["dirichlet_closed"]),
    "files": [sys.modules[name].__file__ for name in sys.modules if name.startswith("dirichlet")],
}))
"""


@pytest.fixture
def archive(tmp_path):
    """Zipped from the staged add-on, as `./run package` does."""
    packager = ROOT / "blender_scripts" / "package_extension.py"
    subprocess.run([sys.executable, str(packager), str(STAGED), str(tmp_path)], check=True, capture_output=True)
    return next(tmp_path.glob("*.zip"))


@pytest.fixture
def blender(tmp_path):
    """Runs a script in a Blender of its own, whose configuration starts empty and is kept for the next call."""
    home = tmp_path / "configuration"
    folders = {
        "BLENDER_USER_RESOURCES": home,
        "BLENDER_USER_CONFIG": home / "config",
        "BLENDER_USER_SCRIPTS": home / "scripts",
    }
    for folder in folders.values():
        folder.mkdir(parents=True, exist_ok=True)
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "DIRICHLET_ADDON")}
    environment |= {name: str(folder) for name, folder in folders.items()}

    def run(script):
        command = [bpy.app.binary_path, "--background", "--python-exit-code", "1", "--python-expr", script]
        done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    run.home = home
    return run


def test_installed_zip_stays_enabled_and_its_operators_run(archive, blender, surface):
    blender(INSTALL.format(archive=str(archive)))
    result = json.loads(blender(USE).partition("RESULT")[2].splitlines()[0])
    assert result["files"]
    assert all(blender.home in Path(file).parents for file in result["files"])
    bpy.ops.mesh.primitive_cube_add()
    cube = bpy.context.active_object.data
    mesh = surface.Mesh([tuple(v.co) for v in cube.vertices], np.array([tuple(p.vertices) for p in cube.polygons]))
    expected = surface.solve(mesh, [0, 7], [0, 1]).values.astype(np.float32)
    assert result["field"] == expected.tolist()
    assert result["closed"]
    assert all(result["closed"])
