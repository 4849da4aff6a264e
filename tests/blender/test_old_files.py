# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that an older Blender saved stay what they were."""

import json

import bpy
import numpy as np
import old_file


def test_a_file_saved_in_3_4_keeps_its_settings_and_gives_the_same_field(addon):
    bpy.ops.wm.open_mainfile(filepath=str(old_file.FILE))
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
