# SPDX-License-Identifier: GPL-3.0-or-later
"""A user's configuration of Blender that starts empty, with the add-on installed from its zip as users do it."""

import os
import subprocess
import zipfile
from pathlib import Path

_INSTALL = """
import bpy
bpy.ops.preferences.addon_install(filepath={archive!r}, overwrite=True)
bpy.ops.preferences.addon_enable(module="dirichlet_isolines")
bpy.ops.wm.save_userpref()
"""
_SWITCH = """
import bpy
bpy.ops.preferences.addon_{act}(module={module!r})
bpy.ops.wm.save_userpref()
"""
_REMOVE = """
import bpy
window = bpy.context.window_manager.windows[0]
with bpy.context.temp_override(window=window, area=window.screen.areas[0]):
    bpy.ops.preferences.addon_remove(module="dirichlet_isolines")
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


def home_of(environment: dict[str, str]) -> Path:
    return Path(environment["BLENDER_USER_RESOURCES"])


def run(blender: str, environment: dict[str, str], script: str) -> str:
    """What the script prints in a Blender without window."""
    return _start([blender, "--background", "--python-exit-code", "1", "--python-expr", script], environment)


def install(blender: str, environment: dict[str, str], archive: Path) -> str:
    """Preferences > Add-ons > Install, enable, Save Preferences; from Blender 4.2 on Install from Disk.

    Over an earlier version this is the upgrade. Gives what Blender prints.
    """
    if _is_extension(archive):
        return extension(blender, environment, "install-file", "-r", "user_default", "-e", str(archive))
    return run(blender, environment, _INSTALL.format(archive=str(archive)))


def disable(blender: str, environment: dict[str, str], archive: Path) -> str:
    """Untick what was installed from the archive, Save Preferences. Gives what Blender prints."""
    return run(blender, environment, _SWITCH.format(act="disable", module=_module(archive)))


def enable(blender: str, environment: dict[str, str], archive: Path) -> str:
    """Tick it again, Save Preferences. Gives what Blender prints."""
    return run(blender, environment, _SWITCH.format(act="enable", module=_module(archive)))


def remove(blender: str, environment: dict[str, str], archive: Path) -> str:
    """Delete what was installed from the archive, enabled or not. Gives what Blender prints."""
    if _is_extension(archive):
        return extension(blender, environment, "remove", "dirichlet_isolines")
    return run(blender, environment, _REMOVE)


def extension(blender: str, environment: dict[str, str], *words: str) -> str:
    """blender --command extension WORDS."""
    return _start([blender, "--command", "extension", *words], environment)


def _module(archive: Path) -> str:
    return "bl_ext.user_default.dirichlet_isolines" if _is_extension(archive) else "dirichlet_isolines"


def _is_extension(archive: Path) -> bool:
    with zipfile.ZipFile(archive) as content:
        return "blender_manifest.toml" in content.namelist()


def _start(command: list[str], environment: dict[str, str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Traceback" not in done.stdout + done.stderr
    return done.stdout + done.stderr
