# SPDX-License-Identifier: GPL-3.0-or-later
"""A user's configuration of Blender that starts empty, with the add-on installed from its zip as users do it."""

import os
import subprocess
from pathlib import Path

_INSTALL = """
import bpy
bpy.ops.preferences.addon_install(filepath={archive!r})
bpy.ops.preferences.addon_enable(module="dirichlet_isolines")
bpy.ops.wm.save_userpref()
"""


def empty(home: Path) -> dict[str, str]:
    """The environment of a Blender that keeps its configuration and temporary files in the folder, made here."""
    folders = {
        "BLENDER_USER_RESOURCES": home,
        "BLENDER_USER_CONFIG": home / "config",
        "BLENDER_USER_SCRIPTS": home / "scripts",
        "TMPDIR": home / "temporary",
    }
    for folder in folders.values():
        folder.mkdir(parents=True, exist_ok=True)
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "DIRICHLET_ADDON")}
    return environment | {name: str(folder) for name, folder in folders.items()}


def run(blender: str, environment: dict[str, str], script: str) -> str:
    """What the script prints in a Blender without window."""
    command = [blender, "--background", "--python-exit-code", "1", "--python-expr", script]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Traceback" not in done.stdout + done.stderr
    return done.stdout


def install(blender: str, environment: dict[str, str], archive: Path) -> None:
    """Preferences > Add-ons > Install, enable, Save Preferences."""
    run(blender, environment, _INSTALL.format(archive=str(archive)))
