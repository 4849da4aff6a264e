# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings that are copied, kept as presets and brought back."""

import importlib

import bpy
import configuration
import pytest
from archives import STAGED
from refusal import assert_refused
from scene import grid, painted_grid, painted_sphere

# A name of our own, so that no preset of the user's is touched.
NAME = "a test of the presets"


@pytest.fixture
def setups(addon):
    return importlib.import_module(f"{addon.__name__}.blender.setups")


@pytest.fixture
def presets(addon):
    return importlib.import_module(f"{addon.__name__}.ui.field.presets").PRESETS


@pytest.fixture
def kept():
    """Keeps the active object's settings as a preset; its file."""
    bpy.ops.dirichlet.preset_add(name=NAME)
    yield bpy.utils.preset_find(NAME, "dirichlet_isolines", display_name=True)
    bpy.ops.dirichlet.preset_add(name=NAME, remove_name=True)
    assert bpy.utils.preset_find(NAME, "dirichlet_isolines", display_name=True) is None


def solved(make=painted_grid, **settings):
    obj = make()
    bpy.ops.dirichlet.solve_field()
    for name, value in settings.items():
        setattr(obj.dirichlet, name, value)
    return obj


def other_values(group):
    """A value for every property that a user can set, different from the one it has."""
    for found in group.bl_rna.properties:
        value = getattr(group, found.identifier)
        if found.identifier in ("name", "ramp_stops") or found.is_skip_save or getattr(found, "is_array", False):
            continue
        if found.type == "BOOLEAN":
            yield found.identifier, not value
        elif found.type in ("INT", "FLOAT"):
            yield found.identifier, found.soft_max if value < found.soft_max < 1e6 else value + 3
        elif found.type == "STRING":
            yield found.identifier, "0.5"
        elif found.type == "ENUM":
            yield found.identifier, next(item.identifier for item in found.enum_items if item.identifier != value)


def stops(obj):
    ramp = obj.material_slots[0].material.node_tree.nodes["Dirichlet Ramp"].color_ramp
    return ramp.interpolation, [(stop.position, *stop.color) for stop in ramp.elements]


def test_every_setting_is_copied_to_the_selected_meshes_and_nothing_else():
    target, bystander = painted_grid(columns=9, name="target"), painted_grid(name="bystander")
    for obj in (target, bystander):
        obj.select_set(False)  # Solve Field takes all that are selected
    source = solved()
    target.select_set(True)
    before = [(patch.group, patch.value) for patch in target.dirichlet.patches]
    for name, value in other_values(source.dirichlet):
        setattr(source.dirichlet, name, value)
    source.dirichlet.patches[0].value = 7.0
    expected = {name: getattr(source.dirichlet, name) for name, _ in other_values(source.dirichlet)}
    assert {"count", "threshold", "method", "window_low", "window_auto"} < expected.keys()
    assert bpy.ops.dirichlet.copy_settings() == {"FINISHED"}
    assert {name: getattr(target.dirichlet, name) for name in expected} == expected
    assert [(patch.group, patch.value) for patch in target.dirichlet.patches] == before
    assert target.dirichlet.results.vertices != source.dirichlet.results.vertices
    assert bystander.dirichlet.count == 13


@pytest.mark.parametrize("auto", [True, False])
def test_whole_range_and_window_are_copied_whichever_comes_first(auto):
    target, source = painted_grid(name="target"), solved(window_low=0.2, window_high=0.7)
    source.dirichlet.window_auto = auto
    bpy.ops.dirichlet.copy_settings()
    copied = target.dirichlet
    assert (copied.window_low, copied.window_high) == pytest.approx((0.2, 0.7))
    assert copied.window_auto is auto


def test_a_window_that_was_set_to_what_it_is_at_first_is_copied_to_another_range():
    target = painted_grid(name="target")
    target.dirichlet.patches[1].value = 2.0
    bpy.ops.dirichlet.solve_field()
    solved(window_low=0.0, window_high=1.0, window_auto=False)
    bpy.ops.dirichlet.copy_settings()
    copied = target.dirichlet
    assert (copied.window_low, copied.window_high, copied.window_auto) == (0, 1, False)


def test_copying_brings_the_stops_of_an_edited_ramp():
    target, source = solved(), solved(painted_sphere)
    source.material_slots[0].material.node_tree.nodes["Dirichlet Ramp"].color_ramp.elements[1].color = (1, 0, 1, 1)
    target.select_set(True)
    bpy.ops.dirichlet.copy_settings()
    assert stops(target) == stops(source)
    assert target.material_slots[0].material != source.material_slots[0].material


def test_copying_undoes_in_one_step():
    painted_grid(name="target")
    source = painted_grid(name="source")
    source.dirichlet.count = 31
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.dirichlet.copy_settings("EXEC_DEFAULT", True)
    assert bpy.data.objects["target"].dirichlet.count == 31
    bpy.ops.ed.undo()
    assert bpy.data.objects["target"].dirichlet.count == 13


def test_copying_needs_another_selected_mesh():
    painted_grid()
    assert not bpy.ops.dirichlet.copy_settings.poll()


def test_a_preset_brings_every_setting_and_the_stops_back(setups, request):
    source = solved()
    for name, value in other_values(source.dirichlet):
        setattr(source.dirichlet, name, value)
    source.material_slots[0].material.node_tree.nodes["Dirichlet Ramp"].color_ramp.interpolation = "CONSTANT"
    file = request.getfixturevalue("kept")
    expected, look = setups.read(source), stops(source)
    other = solved(painted_sphere)
    assert setups.read(other) != expected
    assert bpy.ops.dirichlet.apply_preset(filepath=file) == {"FINISHED"}
    assert setups.read(other) == expected
    assert stops(other) == look


def test_a_preset_applied_before_the_first_solve_gives_that_its_ramp():
    obj = painted_grid()
    bpy.ops.dirichlet.apply_preset(preset="ZEBRA_STRIPES")
    bpy.ops.dirichlet.solve_field()
    interpolation, found = stops(obj)
    assert (interpolation, len(found)) == ("CONSTANT", 16)


def test_choosing_a_ramp_ends_the_stops_of_a_preset():
    obj = solved()
    rainbow = stops(obj)
    bpy.ops.dirichlet.apply_preset(preset="ZEBRA_STRIPES")
    assert stops(obj) != rainbow
    obj.dirichlet.ramp_preset = "rainbow"
    assert stops(obj) == rainbow


@pytest.mark.parametrize("before", [(0.0, 0.2), (9.0, 9.5), (-3.0, 20.0), None])
def test_the_band_is_in_the_middle_of_the_range_whatever_the_window_was(before):
    obj = painted_grid()
    obj.dirichlet.patches[1].value = 10.0
    bpy.ops.dirichlet.solve_field()
    if before:
        obj.dirichlet.window_low, obj.dirichlet.window_high = before
    bpy.ops.dirichlet.apply_preset(preset="WINDOW_BAND")
    assert (obj.dirichlet.window_low, obj.dirichlet.window_high) == pytest.approx((4, 6))
    assert obj.dirichlet.window_auto is False


def test_a_window_in_the_range_of_the_field_waits_for_the_field():
    obj = painted_grid()

    def apply(*context):
        return bpy.ops.dirichlet.apply_preset(*context, preset="WINDOW_BAND")

    assert_refused(apply, obj, "object 'Grid' has no field whose range the window can be a part of")


def test_every_preset_that_comes_with_the_addon_does_what_it_says_again_and_again(presets, setups):
    obj = solved()
    for name, preset in presets.items():
        assert bpy.ops.dirichlet.apply_preset(preset=name) == {"FINISHED"}
        first = setups.read(obj)
        assert first["count"] == preset.setup["count"]
        assert first["window_auto"] is preset.setup.get("window_auto", False)
        assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
        assert obj.dirichlet.results.levels == preset.setup["count"]
        bpy.ops.dirichlet.apply_preset(preset=name)
        assert setups.read(obj) == first


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("{'count': 'many'}", "setting 'count' cannot be 'many'"),
        ("{'method': 'guess'}", "setting 'method' cannot be 'guess'"),
        ("{'ramp_stops': '{}'}", "setting 'ramp_stops' cannot be"),
        ("{'count': 3, 'speed': 1}", "no setting 'speed'"),
        ("{'patches': []}", "no setting 'patches'"),
        ("[1, 2]", "preset 'bad' cannot be read: it does not hold settings"),
        ("import os", "preset 'bad' cannot be read: "),
        ("{[]: 1}", "preset 'bad' cannot be read: "),
        ("-" * 3_000 + "1", "preset 'bad' cannot be read: "),
        ("-" * 100_000 + "1", "preset 'bad' cannot be read: "),
    ],
    ids=range(10),
)
def test_a_file_that_is_no_preset_is_refused(tmp_path, text, sentence):
    (tmp_path / "bad.py").write_text(text)
    obj = grid()

    def apply(*context):
        return bpy.ops.dirichlet.apply_preset(*context, filepath=str(tmp_path / "bad.py"))

    assert_refused(apply, obj, sentence)


def test_presets_of_the_user_and_of_the_addon_are_found_by_an_installed_addon(tmp_path):
    environment = configuration.empty(tmp_path)
    addons = tmp_path / "scripts" / "addons"
    addons.mkdir()
    (addons / STAGED.name).symlink_to(STAGED)
    printed = configuration.run(
        bpy.app.binary_path,
        environment,
        f"""
import bpy
assert not bpy.utils.preset_paths("dirichlet_isolines")
bpy.ops.preferences.addon_enable(module={STAGED.name!r})
obj = bpy.data.objects["Cube"]
bpy.ops.dirichlet.apply_preset(preset="FINE_ENGRAVING")
bpy.ops.dirichlet.preset_add(name="mine")
obj.dirichlet.count = 5
file = bpy.utils.preset_find("mine", "dirichlet_isolines")
bpy.ops.dirichlet.apply_preset(filepath=file)
print("RESULT", obj.dirichlet.count, file)
""",
    )
    count, file = printed.partition("RESULT")[2].splitlines()[0].split()
    assert count == "120"
    assert file == str(tmp_path / "scripts" / "presets" / "dirichlet_isolines" / "mine.py")
