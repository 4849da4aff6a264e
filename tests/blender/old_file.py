# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a file for later Blenders, with what it holds here written into a text of its own:

DIRICHLET_ADDON=… blender --background --factory-startup --python tests/blender/old_file.py -- FILE
"""

import importlib
import json
import sys
from pathlib import Path

import bpy

HERE = Path(__file__).resolve().parent
RECORDED = HERE / "saved_in_3_4.blend"  # by an earlier state of the add-on, in Blender 3.4
SETTINGS = {
    "threshold": 0.4,
    "ramp_preset": "grey",
    "levels_mode": "STEP",
    "step": 0.125,
    "phase": 0.25,
    "bevel_depth": 0.002,
    "window_low": 0.1,
    "window_high": 0.8,
}


def record(addon, obj):
    """Settings, patches, the field computed anew in double precision, and the level of every line."""
    settings = importlib.import_module(f"{addon.__name__}.blender.settings")
    field_task = importlib.import_module(f"{addon.__name__}.blender.field_task")
    return {
        "settings": settings.read(obj.dirichlet),
        "patches": [settings.read(patch) for patch in obj.dirichlet.patches],
        "field": field_task.read(obj).compute().field.values.tolist(),
        "levels": list(obj.dirichlet.isolines.data["dirichlet_level"]),
    }


def _save(addon, file):
    import scene

    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    obj = scene.painted_sphere(subdivisions=3)
    scene.paint(obj, "side", [50, 51, 52], 0.3)
    for name, value in SETTINGS.items():
        setattr(obj.dirichlet, name, value)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    bpy.data.texts.new("recorded").write(json.dumps(record(addon, obj)))
    bpy.ops.wm.save_as_mainfile(filepath=str(Path(file).resolve()), compress=True)


if __name__ == "__main__":
    sys.path[:0] = [str(HERE), str(HERE.parents[1] / "blender_scripts")]
    import addon_loader

    _save(addon_loader.load_addon(), addon_loader.script_words()[0])
