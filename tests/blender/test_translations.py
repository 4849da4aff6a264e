# SPDX-License-Identifier: GPL-3.0-or-later
"""The German of everything that people read."""

import importlib
import re

import bpy
import pytest
import texts
from archives import STAGED
from refusal import data_counts
from scene import grid, painted_grid

SOURCES = sorted(path for path in STAGED.rglob("*.py") if "dirichlet_surface" not in path.relative_to(STAGED).parts)


@pytest.fixture
def german(addon):
    translations = importlib.import_module(f"{addon.__name__}.ui.translations")
    return translations.read(STAGED / "ui" / "languages" / "de_DE.txt")


@pytest.fixture
def in_german():
    view = bpy.context.preferences.view
    before = view.language, view.use_translate_interface, view.use_translate_tooltips
    view.language = "de_DE"
    if view.language != "de_DE":
        pytest.skip("this Blender is built without languages")
    view.use_translate_interface = view.use_translate_tooltips = True
    yield
    view.language, view.use_translate_interface, view.use_translate_tooltips = before


def written(addon):
    """Every text, in English."""
    ui = importlib.import_module(f"{addon.__name__}.ui")
    tools = importlib.import_module(f"{addon.__name__}.ui.patches.tools")
    found = {text for cls in ui._CLASSES for text in texts.of_class(cls)}
    found |= {text for tool in tools._TOOLS for text in (tool.bl_label, tool.bl_description)}
    outputs = importlib.import_module(
        f"{addon.__name__}.ui.lines.line_properties"
    )._OUTPUTS  # one of them not in Blender 3
    found |= {text for _, *words in outputs for text in words}
    found |= {text for path in SOURCES for text in texts.of_source(path)}
    return {text for text in found if re.search("[A-Za-z]{2}", text)}


def test_every_text_has_its_german_and_no_german_is_left_over(addon, german):
    english = written(addon)
    assert sorted(english - german.keys()) == []
    assert sorted(german.keys() - english) == []


def test_no_text_is_put_together_before_it_is_translated():
    assert [place for path in SOURCES for place in texts.untranslatable(path)] == []


def test_translations_name_the_same_values_and_end_like_their_original(german):
    for english, text in german.items():
        assert text.strip(), english
        fields = [sorted(re.findall(r"{[^{}]*}", one)) for one in (english, text)]
        assert set(fields[0]) == set(fields[1]), english
        assert english.endswith(".") == text.endswith("."), english
        assert english.endswith(("...", " ")) == text.endswith(("...", " ")), english


def test_descriptions_are_short_enough_to_be_shown_whole(addon):
    ui = importlib.import_module(f"{addon.__name__}.ui")
    for cls in ui._CLASSES:
        description = getattr(cls, "bl_description", "")
        assert len(description.encode()) < 240, cls


def test_labels_reports_and_refusals_are_german(in_german):
    assert bpy.app.translations.pgettext_iface("Solve Field", "Operator") == "Feld lösen"
    obj = grid()
    with pytest.raises(RuntimeError, match="Erst einen Fleck hinzufügen"):
        bpy.ops.dirichlet.solve_field()
    patch = obj.dirichlet.patches.add()
    patch.group = "fehlt"
    before = data_counts()
    with pytest.raises(RuntimeError, match="Objekt 'Grid' hat keine Punktgruppe 'fehlt'"):
        bpy.ops.dirichlet.solve_field()
    assert data_counts() == before


def test_what_is_made_is_the_same_in_german(in_german):
    painted_grid()
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    assert "dirichlet_field" in bpy.context.active_object.data.attributes


def test_a_refusal_of_several_names_the_object_once_in_german_too(module, surface, in_german):
    objects = [painted_grid(name=name) for name in ("One", "Other")]
    objects[1].dirichlet.patches[0].group = "nobody"
    with pytest.raises(surface.InputError, match=r"^Objekt 'Other' hat keine"):
        module("work").run(module("several").solve_fields(objects))
