# SPDX-License-Identifier: GPL-3.0-or-later
"""The German of everything that people read."""

import importlib
import re
from contextlib import suppress

import bpy
import numpy as np
import pytest
import texts
from archives import STAGED
from following import settle
from refusal import data_counts
from scene import grid, paint, painted_grid

SOURCES = sorted(path for path in STAGED.rglob("*.py") if "dirichlet_surface" not in path.relative_to(STAGED).parts)


@pytest.fixture
def german(addon):
    translations = importlib.import_module(f"{addon.__name__}.ui.translations")
    return translations.read(STAGED / "ui" / "languages" / "de_DE.txt")


@pytest.fixture
def in_german():
    view = bpy.context.preferences.view
    before = view.language, view.use_translate_interface, view.use_translate_tooltips
    with suppress(TypeError):  # of 5.0, where there is no such language
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
    found |= set(importlib.import_module(f"{addon.__name__}.sentences").TEMPLATES)
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


def library_sentences(surface):
    """What the library says of paint, values and levels, each as it is said in earnest."""
    mesh = surface.Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 0, 0), (6, 0, 0), (5, 1, 0)], [(0, 1, 2), (3, 4, 5)])
    flat = surface.Mesh([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)])
    field, undefined = np.arange(6.0), np.full(6, np.nan)
    both = [surface.Patch("a", [0, 1, 2], 0.0), surface.Patch("b", [0, 1], 0.1)]
    thrice = [both[0], surface.Patch("c", [0, 1, 2], 0.1)]
    empty = [surface.Patch(name, [], 0.0) for name in "abcd"]
    for refused in (
        lambda: surface.combine_patches(both, 6),
        lambda: surface.combine_patches(thrice, 6),
        lambda: surface.combine_patches([both[0], surface.Patch("it's 'b'", [1], 1.0)], 6),
        lambda: surface.combine_patches([], 6),
        lambda: surface.combine_patches(empty[:1], 6),
        lambda: surface.combine_patches(empty[:2], 6),
        lambda: surface.combine_patches(empty, 6),
        lambda: surface.even_levels(2, 1, 5),
        lambda: surface.equal_area_levels(mesh, field, 3, 7, 8),
        lambda: surface.equal_area_levels(flat, field[:3], 3),
        lambda: surface.even_levels(0, 1, 0),
        lambda: surface.even_levels(0, 1, 2_000_000),
        lambda: surface.stepped_levels(0, 1, 0.0),
        lambda: surface.stepped_levels(0, 1, 1e-9),
        lambda: surface.isolines(mesh, field, [np.nan]),
        lambda: surface.isolines(mesh, field, [1, np.inf, np.inf]),
        lambda: surface.isolines(mesh, field, [np.inf] * 3),
        lambda: surface.level_through_point(mesh, undefined, (0, 0, 0)),
    ):
        with pytest.raises(surface.InputError) as refusal:
            refused()
        yield str(refusal.value)
    yield from surface.combine_patches([both[0], empty[1]], 6).warnings
    yield from surface.combine_patches([both[0], *empty[1:]], 6).warnings
    yield from surface.solve(mesh, [0, 1, 2], [1.0, 1.0, 1.0]).report.warnings
    lone = surface.Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 0, 0)], [(0, 1, 2)])
    yield from surface.solve(lone, [0, 1], [0.0, 1.0]).report.warnings
    for listed in ([1, 1], [1, 1, 1], [9], [9, 10], [2.5], [2.25, 2.5]):
        yield from surface.isolines(mesh, field, listed).warnings


def test_what_the_library_says_of_paint_values_and_levels_is_german_too(addon, surface, in_german):
    sentences = importlib.import_module(f"{addon.__name__}.sentences")
    said = list(library_sentences(surface))
    english = re.compile(r"\b(the|is|has|levels?|vert|patch|and|more|lies?)\b")
    assert [text for text in map(sentences.told, said) if english.search(text)] == []
    parts = r"painted: (.*)", r"(.*): left out", r"(\(and .*? more \w+\))"  # of others
    said += [found[1] for text in said for found in (re.search(part, text) for part in parts) if found]
    used = {next((one for one, pattern in sentences._patterns() if pattern.fullmatch(text)), "") for text in said}
    assert set(sentences.TEMPLATES) - used == set()
    assert sentences.told(said[0]) == (
        "Punkt 0 ist in 'a' mit Wert 0 und in 'b' mit Wert 0.1 (und 1 weiterer Punkt): "
        "welcher gilt, sagt „Überlappung“ in den Optionen der Flecken"
    )
    assert sentences.told("what nobody has translated") == "what nobody has translated"


def test_in_english_the_library_is_quoted_word_for_word(addon, surface):
    sentences = importlib.import_module(f"{addon.__name__}.sentences")
    said = list(library_sentences(surface))
    assert list(map(sentences.told, said)) == said


def test_overlaps_are_refused_in_german_by_solve_and_by_live(live, in_german):
    obj = painted_grid()
    paint(obj, "left", [11])
    with pytest.raises(RuntimeError, match="Punkt 11 ist in 'left' mit Wert 0 und in 'right' mit Wert 1"):
        bpy.ops.dirichlet.solve_field()
    obj.dirichlet.live = True
    settle(live)
    assert obj.dirichlet.results.problem.startswith("Punkt 11 ist in 'left'")


def test_what_the_library_refuses_of_one_object_of_several_is_german(module, surface, in_german):
    objects = [painted_grid(name=name) for name in ("One", "Other")]
    paint(objects[1], "left", [11])
    with pytest.raises(surface.InputError, match=r"^Objekt 'Other': Punkt 11 ist in"):
        module("work").run(module("several").solve_fields(objects))


def test_why_a_field_is_older_than_its_patches_is_german(module, in_german):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    paint(obj, "left", [11])
    assert ": Punkt 11 ist in 'left'" in module("freshness").doubt(obj)


def test_warnings_of_the_library_are_german(in_german):
    obj = painted_grid()
    paint(obj, "empty", [])
    bpy.ops.dirichlet.solve_field()
    assert obj.dirichlet.results.field_warnings == "Fleck 'empty' hat keine Punkte: ausgelassen"
    obj.dirichlet.levels_mode, obj.dirichlet.levels_list = "LIST", "0.5, 7"
    bpy.ops.dirichlet.make_isolines()
    assert obj.dirichlet.results.isoline_warnings.startswith("Niveau 7 (an Position 1) liegt außerhalb")


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
