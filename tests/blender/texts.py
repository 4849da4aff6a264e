# SPDX-License-Identifier: GPL-3.0-or-later
"""Every text of the add-on that people read: from its registered classes, and from its sources."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import bpy

_SAID = ("say", "label")  # functions of addon/language.py
_SHOWN = ("label", "operator", "prop", "prop_search", "menu", "popover", "template_list")  # of a layout; text=…
_OWN = {"rna_type", "name", "bl_idname"}  # properties that Blender makes


def of_class(cls: type) -> Iterator[str]:
    """Label, category, description, and those of its properties and their enum items."""
    rna = cls.bl_rna
    if issubclass(cls, bpy.types.Operator):
        rna = getattr(bpy.ops.dirichlet, cls.bl_idname.partition(".")[2]).get_rna_type()
        yield from (rna.name, rna.description)
    else:
        yield from (getattr(cls, name, "") for name in ("bl_label", "bl_category"))
    if issubclass(cls, bpy.types.Operator | bpy.types.PropertyGroup | bpy.types.AddonPreferences):
        for found in rna.properties:
            if found.identifier not in _OWN:
                yield from (found.name, found.description)
                for item in getattr(found, "enum_items", ()):
                    yield from (item.name, item.description)


def of_source(path: Path) -> Iterator[str]:
    """What the code says, shows or reports, as it stands there."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        for shown in _shown(node):
            yield from _literals(shown)


def untranslatable(path: Path) -> Iterator[str]:
    """Where a text is put together before it can be looked up in a table: file, line and text."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        for shown in [*_shown(node), *_raised(node)]:
            for part in ast.walk(shown):
                if isinstance(part, ast.JoinedStr) and _has_word(part):
                    yield f"{path.name}:{part.lineno}: {ast.unparse(part)}"


def _shown(node: ast.AST) -> Iterator[ast.expr]:
    if not isinstance(node, ast.Call):
        return
    name = getattr(node.func, "attr", getattr(node.func, "id", ""))
    if isinstance(node.func, ast.Name) and name in _SAID:
        yield node.args[0]
    elif isinstance(node.func, ast.Name) and name == "counted":
        yield from node.args[1:]
    elif name == "report" and len(node.args) == 2:
        yield node.args[1]
    elif name in ("poll_message_set", "status_text_set", "header_text_set"):
        yield from node.args
    elif isinstance(node.func, ast.Attribute) and name in _SHOWN:
        yield from (keyword.value for keyword in node.keywords if keyword.arg == "text")


def _raised(node: ast.AST) -> Iterator[ast.expr]:
    if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
        yield from node.exc.args


def _literals(expression: ast.expr) -> Iterator[str]:
    """The texts that an expression may come to."""
    if isinstance(expression, ast.Constant) and isinstance(expression.value, str):
        yield expression.value
    elif isinstance(expression, ast.IfExp):
        yield from _literals(expression.body)
        yield from _literals(expression.orelse)
    elif isinstance(expression, ast.BoolOp):
        for value in expression.values:
            yield from _literals(value)


def _has_word(text: ast.JoinedStr) -> bool:
    return any(isinstance(part, ast.Constant) and re.search("[A-Za-z]{3}", part.value) for part in text.values)
