# SPDX-License-Identifier: GPL-3.0-or-later
"""The ramp that users edit, the colours through it, and other materials."""

import importlib

import bpy
import numpy as np
import pytest
from following import settle
from scene import add, colors_of, field_of, paint, painted_grid


@pytest.fixture
def material(addon):
    return importlib.import_module(f"{addon.__name__}.blender.look.material")


def solve():
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}


def ramp_colors(ramp, places):
    return np.array([ramp.evaluate(float(place)) for place in places], np.float32)


def test_colors_are_the_ramp_at_the_field():
    obj = painted_grid()
    solve()
    ramp = obj.material_slots[0].material.node_tree.nodes["Dirichlet Ramp"].color_ramp
    assert np.allclose(colors_of(obj), ramp_colors(ramp, field_of(obj)), atol=2e-3)


def test_ramp_spans_the_field_whatever_its_values(material):
    obj = painted_grid()
    obj.dirichlet.patches[0].value, obj.dirichlet.patches[1].value = -40.0, 60.0
    solve()
    ramp = material.find_ramp(obj).color_ramp
    assert np.allclose(colors_of(obj), ramp_colors(ramp, (field_of(obj) + 40) / 100), atol=2e-3)


@pytest.mark.parametrize("interpolation", ["CONSTANT", "LINEAR", "EASE", "B_SPLINE"])
def test_edited_ramp_colors_the_attribute(material, interpolation):
    obj = painted_grid()
    solve()
    ramp = material.find_ramp(obj).color_ramp
    ramp.interpolation = interpolation
    ramp.elements.new(0.3).color = (1, 0, 1, 1)
    assert bpy.ops.dirichlet.update_colors() == {"FINISHED"}
    assert np.allclose(colors_of(obj), ramp_colors(ramp, field_of(obj)), atol=2e-3)


def test_constant_ramp_jumps_exactly_at_its_stops(addon, material):
    obj = painted_grid()
    solve()
    ramp = material.find_ramp(obj).color_ramp
    ramp.interpolation = "CONSTANT"
    places = np.array([place + shift for place in (0.25, 0.5, 0.75) for shift in (-1e-6, 0, 1e-6)])
    table = importlib.import_module(f"{addon.__name__}.blender.look.ramp").read_table(obj)
    assert np.array_equal(table.apply(places, (0.0, 1.0)), ramp_colors(ramp, places))


def test_solving_again_keeps_the_edited_ramp(material):
    obj = painted_grid()
    solve()
    material.find_ramp(obj).color_ramp.elements[0].color = (1, 0, 1, 1)
    solve()
    assert np.allclose(colors_of(obj)[0], (1, 0, 1, 1))


def test_constant_field_takes_the_middle_of_the_ramp(material):
    obj = painted_grid()
    obj.dirichlet.patches[0].value = 1.0
    solve()
    assert np.allclose(colors_of(obj), material.find_ramp(obj).color_ramp.evaluate(0.5), atol=2e-3)


@pytest.mark.parametrize("preset", ["rainbow", "viridis", "grey", "red-blue"])
def test_preset_replaces_the_stops_and_the_colors(addon, material, preset):
    obj = painted_grid()
    solve()
    obj.dirichlet.ramp_preset = preset
    stops = importlib.import_module(f"{addon.__name__}.library").load("ramps").RAMPS[preset]
    shown = material.find_ramp(obj).color_ramp.elements
    assert [stop.position for stop in shown] == pytest.approx([place for place, _ in stops])
    assert np.allclose([tuple(stop.color)[:3] for stop in shown], [color for _, color in stops])
    assert np.allclose(colors_of(obj)[0][:3], stops[0][1])


@pytest.mark.parametrize("evaluated", [True, False])
def test_ramp_chosen_in_edit_mode_colors_the_mesh_when_it_is_left(material, live, evaluated, capfd):
    obj = painted_grid()
    solve()
    bpy.ops.object.mode_set(mode="EDIT")
    obj.dirichlet.ramp_preset = "grey"
    if evaluated:
        settle(live)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    live.flush()
    assert "Traceback" not in "".join(capfd.readouterr())
    assert np.allclose(colors_of(obj), ramp_colors(material.find_ramp(obj).color_ramp, field_of(obj)), atol=2e-3)
    assert np.ptp(colors_of(obj)[:, :3], axis=1).max() < 1e-6


def test_preset_leaves_ramp_and_colors_when_a_name_is_taken(material, pipeline, surface, capfd):
    obj = painted_grid()
    solve()
    shown, colors = [tuple(stop.color) for stop in material.find_ramp(obj).color_ramp.elements], colors_of(obj)
    obj.vertex_groups.new(name="dirichlet_color")
    obj.dirichlet.ramp_preset = "grey"
    assert "Traceback" not in "".join(capfd.readouterr())
    with pytest.raises(surface.InputError, match="'dirichlet_color' of mesh 'Grid' is a vertex group"):
        pipeline.apply_look(obj)
    assert [tuple(stop.color) for stop in material.find_ramp(obj).color_ramp.elements] == shown
    assert np.array_equal(colors_of(obj), colors)


def test_updating_colors_makes_them_anew_and_leaves_the_field_alone(pipeline, monkeypatch):
    obj = painted_grid()
    solve()
    field, colors = field_of(obj), colors_of(obj)
    obj.data.attributes.remove(obj.data.attributes["dirichlet_color"])
    monkeypatch.setattr(pipeline.attributes, "write", lambda *_: pytest.fail("the field was written"))
    assert bpy.ops.dirichlet.update_colors() == {"FINISHED"}
    assert np.array_equal(field_of(obj), field)
    assert np.allclose(colors_of(obj), colors, atol=1e-6)
    assert obj.data.color_attributes.active_color_name == "dirichlet_color"


def test_presets_are_the_library_ramps(addon):
    ramps = importlib.import_module(f"{addon.__name__}.library").load("ramps").RAMPS
    settings = bpy.types.Object.bl_rna.properties["dirichlet"].fixed_type
    assert set(settings.properties["ramp_preset"].enum_items.keys()) == set(ramps)


def test_preset_chosen_before_solving_is_used(material):
    obj = painted_grid()
    obj.dirichlet.ramp_preset = "grey"
    solve()
    assert len(set(material.find_ramp(obj).color_ramp.elements[0].color[:3])) == 1


def test_color_attribute_is_active_for_display_and_render():
    obj = painted_grid()
    obj.data.attributes.new("other", "FLOAT_COLOR", "POINT")
    solve()
    colors = obj.data.color_attributes
    assert colors.active_color_name == "dirichlet_color"
    assert colors[colors.render_color_index].name == "dirichlet_color"


def test_user_material_survives_on_the_mesh_and_comes_back():
    obj = painted_grid()
    users = [bpy.data.materials.new(name) for name in ("wood", "metal")]
    for found in users:
        obj.data.materials.append(found)
    obj.data.polygons[3].material_index = 1
    solve()
    shown = {slot.material for slot in obj.material_slots}
    assert len(shown) == 1
    assert not shown & set(users)
    assert list(obj.data.materials) == users
    assert obj.data.polygons[3].material_index == 1
    assert bpy.ops.dirichlet.restore_materials() == {"FINISHED"}
    assert [slot.material for slot in obj.material_slots] == users


def test_material_on_the_object_is_left_and_said(pipeline):
    obj = painted_grid()
    obj.data.materials.append(None)
    own = bpy.data.materials.new("own")
    obj.material_slots[0].link = "OBJECT"
    obj.material_slots[0].material = own
    result = pipeline.solve_field(obj)
    assert obj.material_slots[0].material == own
    assert any("'own'" in warning for warning in result.warnings)


def test_empty_slot_takes_the_field_material(material):
    obj = painted_grid()
    obj.data.materials.append(None)
    solve()
    assert obj.material_slots[0].material == material.find(obj)
    assert len(obj.material_slots) == 1


def test_duplicated_object_gets_a_ramp_of_its_own(material):
    obj = painted_grid()
    solve()
    bpy.ops.object.duplicate()
    copy = bpy.context.active_object
    copy.dirichlet.patches[1].value = 50.0
    solve()
    assert material.find(copy) != material.find(obj)
    assert material.find(obj).node_tree.nodes["Dirichlet Range"].inputs["From Max"].default_value == 1


@pytest.mark.parametrize("write", ["solve", "ramp", "stripes"])
def test_a_material_of_another_file_is_copied_and_not_written(material, write, tmp_path):
    painted_grid()
    solve()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "other.blend"))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    obj = painted_grid()
    solve()
    own = material.find(obj)
    with bpy.data.libraries.load(str(tmp_path / "other.blend"), link=True) as (_, taken):
        taken.materials = [own.name]
    (linked,) = taken.materials
    obj.material_slots[0].material = linked
    stops = [tuple(stop.color) for stop in linked.node_tree.nodes["Dirichlet Ramp"].color_ramp.elements]
    if write == "solve":
        obj.dirichlet.patches[1].value = 50.0
        solve()
        assert material.find(obj).node_tree.nodes["Dirichlet Range"].inputs["From Max"].default_value == 50
    elif write == "ramp":
        obj.dirichlet.ramp_preset = "grey"
        assert len(set(material.find_ramp(obj).color_ramp.elements[0].color[:3])) == 1
    else:
        assert bpy.ops.dirichlet.add_stripes() == {"FINISHED"}
    assert not material.find(obj).library
    tree = linked.node_tree
    assert tree.nodes["Dirichlet Range"].inputs["From Max"].default_value == 1
    assert [tuple(stop.color) for stop in tree.nodes["Dirichlet Ramp"].color_ramp.elements] == stops
    assert len(tree.nodes) == len(own.node_tree.nodes)


def test_colors_of_a_mesh_that_lost_its_vertices_are_none(capfd):
    obj = painted_grid()
    solve()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.delete(type="VERT")
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.dirichlet.update_colors() == {"FINISHED"}
    obj.dirichlet.ramp_preset = "grey"
    assert "Traceback" not in "".join(capfd.readouterr())
    assert not len(obj.data.attributes["dirichlet_color"].data)


@pytest.mark.parametrize("text", ["red", "[]", "[" * 100_000], ids=["a word", "a list", "too deep"])
@pytest.mark.parametrize("before", [True, False])
def test_stops_that_are_none_give_the_ramp_chosen(material, text, before, capfd):
    obj = painted_grid()
    obj.dirichlet.ramp_preset = "grey"
    if before:
        solve()
    obj.dirichlet.ramp_stops = text
    solve()
    assert len(set(material.find_ramp(obj).color_ramp.elements[0].color[:3])) == 1
    assert "Traceback" not in "".join(capfd.readouterr())


def test_renamed_material_is_found_again():
    obj = painted_grid()
    solve()
    obj.material_slots[0].material.name = "mine now"
    solve()
    assert len(bpy.data.materials) == 1


def test_rendered_material_shows_the_ramp_and_grey_where_undefined(tmp_path):
    corners = [(x, y, 0.0) for x in (0, 1, 2, 3) for y in (0, 1)]
    obj = add(corners, [(0, 2, 3, 1), (4, 6, 7, 5)])
    paint(obj, "a", [0, 1], 0.0)
    paint(obj, "b", [2, 3], 1.0)
    solve()
    left, middle, right, undefined = render_from_above(tmp_path / "picture.png", [0.05, 0.5, 0.95, 2.5])
    assert left.argmax() == 2
    assert middle.argmax() == 1
    assert right.argmax() == 0
    assert np.ptp(undefined) < 0.02
    assert 0.2 < undefined.mean() < 0.8


def render_from_above(file, places):
    """RGB at points (x, 0.5) of a plane that fills x in [0, 3], rendered in an even light."""
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", 3
    camera.location = (1.5, 0.5, 5)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("world")
    if bpy.app.version < (5, 0, 0):
        scene.world.use_nodes = True  # later worlds always do
    background = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 16, False
    scene.render.resolution_x, scene.render.resolution_y = 60, 20
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)
    pixels = np.array(bpy.data.images.load(str(file)).pixels[:]).reshape(20, 60, 4)
    return [pixels[8:12, int(20 * x), :3].mean(axis=0) for x in places]
