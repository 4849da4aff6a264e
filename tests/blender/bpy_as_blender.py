# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module `bpy` behind as much of Blender's command line as the tests use:

python bpy_as_blender.py PROGRAM [WORD…]     PROGRAM: what starts this, for scripts that start another Blender
"""

import os
import runpy
import sys
from pathlib import Path

import bpy

_WITHOUT_MEANING = ("--background", "-noaudio")


def main(program: str, words: list[str]) -> int:
    """The exit code."""
    if words == ["--version"]:
        print(f"Blender {bpy.app.version_string}")
        return 0
    bpy.app.binary_path = program
    sys.argv = [program, *words]
    if "--factory-startup" not in words:
        bpy.ops.wm.read_userpref()
    if words[0] == "--command":
        _extension(words[2:])
        return 0
    return _act(words[: words.index("--")] if "--" in words else words)


def _act(words: list[str]) -> int:
    """Does what the words say, one after the other."""
    remaining, code = iter(words), 0
    for word in remaining:
        try:
            if word == "--python-exit-code":
                code = int(next(remaining))
            elif word == "--python":
                runpy.run_path(next(remaining), run_name="__main__")
            elif word == "--python-expr":
                exec(next(remaining), {"__name__": "__main__"})
            elif word.endswith(".blend"):
                bpy.ops.wm.open_mainfile(filepath=word)
            elif word not in (*_WITHOUT_MEANING, "--factory-startup"):
                raise SystemExit(f"bpy_as_blender.py does not know {word}")
        except Exception:
            sys.excepthook(*sys.exc_info())
            if code:
                return code
    return 0


def _extension(words: list[str]) -> None:
    """blender --command extension install-file -r user_default -e FILE, or remove NAME."""
    if words[0] == "install-file":
        bpy.ops.extensions.package_install_files(filepath=str(Path(words[-1]).resolve()), repo="user_default")
    else:
        index = [repo.module for repo in bpy.context.preferences.extensions.repos].index("user_default")
        bpy.ops.extensions.package_uninstall(repo_index=index, pkg_id=words[-1])
    bpy.ops.wm.save_userpref()


if __name__ == "__main__":
    status = main(sys.argv[1], sys.argv[2:])
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # the module may crash when Python ends
