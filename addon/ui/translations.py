# SPDX-License-Identifier: GPL-3.0-or-later
"""The languages of the add-on: every file of languages/ is one, named as Blender's locale."""

from pathlib import Path

import bpy

_FOLDER = Path(__file__).parent / "languages"
_CONTEXTS = ("*", "Operator")  # in which Blender looks texts up: the labels of operators, and all others


def read(path: Path) -> dict[str, str]:
    """English -> translation. Lines by turns; empty ones and those that begin with # do not count."""
    text = path.read_text(encoding="utf-8")
    lines = [line for line in map(str.strip, text.splitlines()) if line and line[0] != "#"]
    return dict(zip(lines[::2], lines[1::2], strict=True))


def register() -> None:
    tables = {
        path.stem: {(context, english): text for english, text in read(path).items() for context in _CONTEXTS}
        for path in _FOLDER.glob("*.txt")
    }
    bpy.app.translations.register(__name__, tables)


def unregister() -> None:
    bpy.app.translations.unregister(__name__)
