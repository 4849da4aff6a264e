# SPDX-License-Identifier: GPL-3.0-or-later
"""Registering, saving, undoing: what a session does to the add-on and its data."""

import importlib
import json
import sysconfig
from pathlib import Path

import bpy
import numpy as np
import pytest
from archives import STAGED
from in_new_blender import run_blender
from refusal import data_counts
from scene import colors_of, field_of, painted_sphere


def registered():
    return {name for name in dir(bpy.types) if "DIRICHLET" in name.upper()} | {
        name for name in dir(bpy.types.Object) if "dirichlet" in name
    }


def snapshot():
    """Field, colours and lines of the only mesh object."""
    obj = next(obj for obj in bpy.data.objects if obj.type == "MESH")
    curve = obj.dirichlet.isolines.data
    points = [point.co[:] for spline in curve.splines for point in spline.points]
    lines = [list(curve[name]) for name in ("dirichlet_level", "dirichlet_closed", "dirichlet_length")]
    return field_of(obj).tolist(), colors_of(obj).tolist(), points, lines


def run_both():
    bpy.context.view_layer.objects.active = next(obj for obj in bpy.data.objects if obj.type == "MESH")
    assert bpy.ops.dirichlet.solve_field("EXEC_DEFAULT", True) == {"FINISHED"}
    assert bpy.ops.dirichlet.make_isolines("EXEC_DEFAULT", True) == {"FINISHED"}


def test_unregistering_leaves_nothing_and_registering_again_works(addon):
    before = registered()
    assert "dirichlet" in before
    for _ in range(2):
        addon.unregister()
        try:
            assert registered() == set()
            assert "dirichlet" not in dir(bpy.types.Object)
            with pytest.raises(KeyError):
                bpy.ops.dirichlet.solve_field.get_rna_type()
        finally:
            addon.register()
    assert registered() == before


def test_every_property_and_operator_explains_itself(addon):
    ui = importlib.import_module(f"{addon.__name__}.ui")
    for cls in ui._CLASSES:
        rna = cls.bl_rna
        if issubclass(cls, bpy.types.Operator):
            rna = getattr(bpy.ops.dirichlet, cls.bl_idname.partition(".")[2]).get_rna_type()
            assert len(rna.description) > 20, cls
        if issubclass(cls, (bpy.types.Operator, bpy.types.PropertyGroup)):
            own = [found for found in rna.properties if found.identifier not in ("rna_type", "name")]
            assert [found.identifier for found in own if len(found.description) < 10] == []


def test_saved_and_reloaded_file_holds_and_gives_the_same_result(tmp_path):
    painted_sphere()
    run_both()
    before = snapshot()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    assert snapshot() == before
    counts = data_counts()
    run_both()
    assert snapshot() == before
    assert data_counts() == counts


def test_both_operators_undo_and_redo():
    painted_sphere()
    bpy.ops.ed.undo_push(message="painted")
    counts = data_counts()
    run_both()
    solved = snapshot()
    bpy.ops.ed.undo()
    obj = bpy.data.objects["Sphere"]
    assert "dirichlet_field" in obj.data.attributes
    assert obj.dirichlet.isolines is None
    assert not bpy.data.curves
    bpy.ops.ed.undo()
    obj = bpy.data.objects["Sphere"]
    assert "dirichlet_field" not in obj.data.attributes
    assert "dirichlet_color" not in obj.data.attributes
    assert not obj.material_slots
    assert not obj.dirichlet.results.solved
    assert data_counts() == counts
    bpy.ops.ed.redo()
    bpy.ops.ed.redo()
    assert snapshot() == solved
    run_both()
    assert snapshot() == solved


def test_values_survive_a_file_read_without_the_addon(addon, tmp_path):
    painted_sphere()
    run_both()
    before = snapshot()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    addon.unregister()
    try:
        bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
        bpy.ops.wm.save_mainfile()
    finally:
        addon.register()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    assert snapshot() == before


def test_enabling_imports_neither_numpy_nor_the_library():
    run = run_blender(f"""
import importlib, json, sys
sys.path.insert(0, {str(STAGED.parent)!r})
before = set(sys.modules)
importlib.import_module({STAGED.name!r}).register()
added = sys.modules.keys() - before
print("MODULES", json.dumps([name for name in added if name == "numpy" or "dirichlet_surface" in name]))
""")
    assert json.loads(run.stdout.partition("MODULES")[2].splitlines()[0]) == []


@pytest.mark.parametrize(
    ("module", "words"),
    [
        ("_native.cpython-99-other.so", ["expected _native", "found _native.cpython-99-other.so"]),
        (f"_native{sysconfig.get_config_var('EXT_SUFFIX')}", ["could not be loaded: /", ": file too short"]),
    ],
    ids=["of another Python", "broken"],
)
def test_without_the_library_the_panel_draws_and_the_sentence_says_why(tmp_path, module, words):
    folder = tmp_path / STAGED.name
    folder.mkdir()
    for part in STAGED.iterdir():
        if part.name != "dirichlet_surface":
            (folder / part.name).symlink_to(part)
    (folder / "dirichlet_surface").mkdir()
    (folder / "dirichlet_surface" / "__init__.py").write_text("from . import _native\n")
    (folder / "dirichlet_surface" / module).write_bytes(b"")
    run = run_blender(f"""
import bpy, importlib, sys
sys.path[:0] = {[str(tmp_path), str(Path(__file__).parent)]!r}
addon = importlib.import_module({STAGED.name!r})
addon.register()
from test_panels import drawn
print("PANEL", *drawn("DIRICHLET_PT_patches"))
obj = bpy.context.active_object
obj.vertex_groups.new(name="a")
bpy.ops.dirichlet.patch_add_group()
try:
    bpy.ops.dirichlet.solve_field()
except RuntimeError as error:
    print("SENTENCE", str(error).strip())
print("FAILURE", sys.modules[addon.__name__ + ".library"].failure())
obj.dirichlet.ramp_preset = "grey"
""")
    sentence = run.stdout.partition("SENTENCE")[2].splitlines()[0]
    assert all(word in sentence for word in words)
    panel = run.stdout.partition("PANEL")[2].splitlines()[0]
    assert "dirichlet.patch_add_group" in panel
    assert ("expected _native" in panel) == ("expected _native" in sentence)  # before anything was tried
    assert sentence.count(module) == 1
    assert run.stdout.partition("FAILURE")[2].splitlines()[0].strip() in sentence
    assert "Traceback" not in run.stdout + run.stderr


def test_field_is_finite_in_the_range_of_the_paint():
    obj = painted_sphere()
    run_both()
    values = field_of(obj)
    assert np.isfinite(values).all()
    assert (values.min(), values.max()) == (0, 1)
