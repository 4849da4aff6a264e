# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the project's scripts the way users do, and tests' own: in a Blender of their own."""

import os
import subprocess
from pathlib import Path

import bpy
from archives import ROOT, STAGED


def run_script(name, *words, file=None):
    """blender --background [FILE] --python blender_scripts/NAME -- WORDS: the finished process, with its output."""
    opened = [str(file)] if file else []
    command = [bpy.app.binary_path, "--background", "--factory-startup", "-noaudio", *opened, "--python-exit-code", "1"]
    script = ["--python", str(ROOT / "blender_scripts" / name), "--", *map(str, words)]
    environment = {**os.environ, "DIRICHLET_ADDON": str(STAGED)}
    return subprocess.run([*command, *script], env=environment, capture_output=True, text=True, timeout=600)


def run_blender(script):
    """A new Blender with factory settings and its default scene runs the script and ends."""
    command = [bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "1", "--python-expr"]
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    run = subprocess.run([*command, script], capture_output=True, text=True, env=environment, timeout=120, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    return run


def save(folder: Path, name="scene.blend") -> Path:
    """The open file, as a file."""
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / name), copy=True)
    return folder / name
