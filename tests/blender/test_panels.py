# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels draw, for a layout that writes it down."""

import importlib
from types import SimpleNamespace

import bpy
import pytest


class Layout:
    """Takes everything that a panel asks of it, and remembers the operators and properties."""

    def __init__(self):
        self.drawn = []

    def operator(self, name, **_):
        self.drawn.append(name)
        return SimpleNamespace()

    def prop(self, _, name, **__):
        self.drawn.append(name)

    def label(self, text="", **_):
        self.drawn.append(text)  # empty ones too, which take as much place

    def __getattr__(self, _):
        return lambda *_, **__: self


def context(width=2000):
    """The context of a sidebar so wide."""
    return SimpleNamespace(
        active_object=bpy.context.active_object,
        object=bpy.context.object,
        mode=bpy.context.mode,
        preferences=SimpleNamespace(system=SimpleNamespace(ui_scale=1)),
        region=SimpleNamespace(width=width),
    )


def drawn(panel, width=2000):
    layout = Layout()
    getattr(bpy.types, panel).draw(SimpleNamespace(layout=layout), context(width))
    return layout.drawn


@pytest.fixture
def result(sheet):
    bpy.ops.dirichlet.make_isolines()
    return sheet.dirichlet.isolines


@pytest.mark.parametrize("bound", [True, False])
def test_levels_are_picked_on_the_mesh_object_alone(result, bound):
    assert "dirichlet.pick_level" in drawn("DIRICHLET_PT_isolines")
    if not bound:
        result.parent = None
    bpy.context.view_layer.objects.active = result
    shown = drawn("DIRICHLET_PT_result_sidebar")
    assert "levels_mode" in shown
    assert "dirichlet.pick_level" not in shown


def test_the_window_says_why_it_rests_while_levels_are_listed(sheet):
    def state():
        layout = Layout()
        bpy.types.DIRICHLET_PT_field.draw(SimpleNamespace(layout=layout), context())
        return layout.enabled, "The levels are listed: no window chooses them" in layout.drawn

    assert state() == (True, False)
    sheet.dirichlet.levels_mode = "LIST"
    assert state() == (False, True)


def test_a_result_that_the_user_deleted_has_no_switches(result):
    assert {"follow", "locked"} < set(drawn("DIRICHLET_PT_isolines"))
    bpy.ops.object.select_all(action="DESELECT")
    result.select_set(True)
    bpy.ops.object.delete()
    assert not {"follow", "locked"} & set(drawn("DIRICHLET_PT_isolines"))


def test_a_disowned_result_says_so_and_shows_settings_of_its_own(result):
    bpy.data.objects.remove(result.dirichlet_isolines.source)
    bpy.context.view_layer.objects.active = result
    shown = drawn("DIRICHLET_PT_result_sidebar")
    assert any("is gone" in text for text in shown)
    assert {"dirichlet.result_remove", "source", "levels_mode"} < set(shown)
    drawn("DIRICHLET_PT_result_sidebar_shape")


def test_presets_miss_no_folder_that_another_blender_removed_when_it_ended(addon, sheet):
    panels = importlib.import_module(f"{addon.__name__}.ui.field.presets_panel")
    panels.unregister()
    panels.register()
    shown = presets_drawn(panels)
    assert not any("Missing" in text for text in shown)
    assert "dirichlet.copy_settings" in shown


def test_presets_are_drawn_where_no_folder_can_be_made(addon, sheet, tmp_path, monkeypatch, capfd):
    panels = importlib.import_module(f"{addon.__name__}.ui.field.presets_panel")
    (tmp_path / "file").touch()
    monkeypatch.setattr(panels, "_folder", lambda **options: tmp_path / "file" / "presets")
    assert "dirichlet.copy_settings" in presets_drawn(panels)
    assert "Traceback" not in capfd.readouterr().err


def presets_drawn(panels):
    kind, layout = panels.DIRICHLET_PT_presets, Layout()
    of_presets = {name: getattr(kind, name) for name in dir(kind) if name.startswith(("preset_", "path_"))}
    kind.draw(type("Shown", (), {**of_presets, "layout": layout})(), bpy.context)
    return layout.drawn


def test_what_there_is_to_say_moves_nothing(addon, sheet):
    panels = importlib.import_module(f"{addon.__name__}.ui.panels")
    results, patch = sheet.dirichlet.results, sheet.dirichlet.patches[0]
    heights = set()
    for solved, vertices, problem in ((False, 0, ""), (True, 9, ""), (True, 9, "Overlaps 'Disc.001', 'Disc.002'")):
        results.solved, results.problem, patch.vertices, patch.problem = solved, problem, vertices, problem
        layout = Layout()
        panels._draw_patch(layout, context(250), patch)
        heights.add((len(drawn("DIRICHLET_PT_field", 250)), len(layout.drawn)))
    assert len(heights) == 1
