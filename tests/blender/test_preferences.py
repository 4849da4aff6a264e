# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user prefers, with the add-on enabled in a configuration of its own, and without."""

import importlib
import json

import bpy
import configuration
import pytest
from archives import STAGED
from scene import grid, painted_sphere

ENABLE = f"import bpy\nbpy.ops.preferences.addon_enable(module={STAGED.name!r})"
LOOK = f"""
import bpy, importlib, json
chosen = bpy.context.preferences.addons[{STAGED.name!r}].preferences
preferences = importlib.import_module("{STAGED.name}.blender.preferences")
"""


@pytest.fixture
def preferences(addon):
    return importlib.import_module(f"{addon.__name__}.blender.preferences")


@pytest.fixture
def run(tmp_path):
    """Runs a script in a Blender whose configuration has the add-on, and is kept for the next call; gives what it
    prints as JSON."""
    environment = configuration.empty(tmp_path)
    addons = tmp_path / "scripts" / "addons"
    addons.mkdir()
    (addons / STAGED.name).symlink_to(STAGED)

    def blender(script):
        printed = configuration.run(bpy.app.binary_path, environment, script)
        return json.loads(printed.partition("RESULT")[2].splitlines()[0])

    return blender


def test_without_being_enabled_the_defaults_hold(preferences):
    assert preferences.get() == preferences.DEFAULTS
    assert preferences.memory_budget() is None


def test_enabled_every_preference_begins_with_its_default(run, preferences):
    names = sorted(vars(preferences.DEFAULTS))
    values = run(ENABLE + LOOK + f'print("RESULT", json.dumps([getattr(preferences.get(), name) for name in {names}]))')
    for name, value in zip(names, values):
        default = getattr(preferences.DEFAULTS, name)
        assert value == (pytest.approx(default, rel=1e-6) if isinstance(default, float) else default)


def test_preferences_are_kept_for_the_next_start(run):
    run(ENABLE + LOOK + 'chosen.memory_budget, chosen.ramp = 3, "grey"\nbpy.ops.wm.save_userpref()\nprint("RESULT", 0)')
    script = 'print("RESULT", json.dumps([preferences.memory_budget(), preferences.get().ramp]))'
    assert run(LOOK + script) == [3 * 2**20, "grey"]


def test_only_the_first_patch_brings_the_preferred_ramp(preferences, monkeypatch):
    monkeypatch.setattr(preferences, "DEFAULTS", preferences.Preferences(ramp="viridis"))
    fresh, chosen, begun = grid(name="fresh"), grid(name="chosen"), painted_sphere()
    chosen.dirichlet.ramp_preset = "rainbow"
    bpy.context.view_layer.objects.active = brought = grid(name="brought")
    bpy.ops.dirichlet.apply_preset(preset="TOPOGRAPHIC")
    stops = brought.dirichlet.ramp_stops
    for obj in (fresh, chosen, begun, brought):
        bpy.context.view_layer.objects.active = obj
        obj.vertex_groups.new(name="another")
        bpy.ops.dirichlet.patch_add_group(group="another")
    assert [obj.dirichlet.ramp_preset for obj in (fresh, chosen, begun)] == ["viridis", "rainbow", "rainbow"]
    assert (brought.dirichlet.ramp_preset, brought.dirichlet.ramp_stops) == ("rainbow", stops)
    assert stops


def test_the_memory_budget_makes_the_automatic_method_turn_to_multigrid(preferences, pipeline, monkeypatch):
    obj = painted_sphere(7)
    assert pipeline.solve_field(obj).field.report.method == "direct"
    monkeypatch.setattr(preferences, "DEFAULTS", preferences.Preferences(memory_budget=1))
    assert pipeline.solve_field(obj).field.report.method == "multigrid"


@pytest.mark.parametrize(("threads", "limit"), [(0, None), (3, 3)])
def test_the_library_is_told_how_many_threads_it_may_use(threads, limit, preferences, pipeline, surface, monkeypatch):
    told = []
    monkeypatch.setattr(preferences, "DEFAULTS", preferences.Preferences(threads=threads))
    monkeypatch.setattr(surface, "set_thread_limit", told.append)
    pipeline.solve_field(painted_sphere())
    assert told == [limit]
