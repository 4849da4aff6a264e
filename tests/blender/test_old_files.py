# SPDX-License-Identifier: GPL-3.0-or-later
"""Files stay what they were: one of an older version of the add-on, recorded, and one of another Blender, that named in
DIRICHLET_SAVED, of 3.4, else made here."""

import json
import os
from pathlib import Path

import bpy
import numpy as np
import old_file
import pytest
from in_new_blender import run_script


@pytest.fixture(params=["recorded", "saved"])
def file(request, tmp_path):
    if request.param == "recorded":
        return old_file.RECORDED
    named = os.environ.get("DIRICHLET_SAVED")
    if named:
        return Path(named)
    done = run_script(old_file.__file__, tmp_path / "saved.blend")
    assert done.returncode == 0, done.stderr
    return tmp_path / "saved.blend"


def test_an_older_file_keeps_its_settings_and_gives_the_same_field(addon, file):
    bpy.ops.wm.open_mainfile(filepath=str(file))
    obj = bpy.data.objects["Sphere"]
    recorded = json.loads(bpy.data.texts["recorded"].as_string())
    found = json.loads(json.dumps(old_file.record(addon, obj)))
    assert found["settings"] == found["settings"] | recorded["settings"]  # later versions may have more of them
    assert len(found["patches"]) == len(recorded["patches"])
    assert all(patch == patch | old for patch, old in zip(found["patches"], recorded["patches"]))
    assert found["levels"] == recorded["levels"]
    assert np.abs(np.subtract(found["field"], recorded["field"])).max() < 1e-12
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    assert list(obj.dirichlet.isolines.data["dirichlet_level"]) == recorded["levels"]
