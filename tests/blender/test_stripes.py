# SPDX-License-Identifier: GPL-3.0-or-later
"""Stripes: lines that the field's material draws, as Cycles renders them."""

import importlib

import bpy
import numpy as np
import pytest
from refusal import assert_refused, data_counts
from scene import add, paint, painted_grid

_PIXELS = 400
_PLACES = (np.arange(_PIXELS) + 0.5) / _PIXELS  # of the pixels of a row, from 0 to 1


@pytest.fixture
def stripes(addon):
    return importlib.import_module(f"{addon.__name__}.blender.look.stripes")


@pytest.fixture
def sheet():
    """x / 10 on 0 to 10, and its field material."""
    obj = painted_grid(columns=11)
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    return obj


def render(obj, output, name, width=10.0):
    """The values (400,) of a stripes' output along the line y = 0.5 from x = 0 to `width`."""
    tree = obj.material_slots[0].material.node_tree
    emission = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(output, emission.inputs["Color"])
    surface = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL").inputs["Surface"]
    tree.links.new(emission.outputs[0], surface)
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", width
    scene.camera.location = (width / 2, 0.5, 5)
    scene.collection.objects.link(scene.camera)
    scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 1, False
    scene.render.filter_size = scene.cycles.filter_width = 0.01
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = _PIXELS, 4, 100
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = str(name)
    bpy.ops.render.render(write_still=True)
    pixels = np.array(bpy.data.images.load(str(name)).pixels[:]).reshape(4, _PIXELS, 4)
    return pixels[1, :, 0]


def assert_drawn(mask, levels, half_width, values=_PLACES):
    """1 within half a width of a level and 0 elsewhere; the pixel that an edge crosses may be either."""
    distance = np.abs(values[:, None] - levels).min(axis=1) if len(levels) else np.full(len(values), np.inf)
    clear = np.abs(distance - half_width) > 1.0 / _PIXELS
    assert np.array_equal(mask[clear], (distance < half_width)[clear].astype(np.float32))
    assert clear.mean() > 0.6


def inputs_of(node):
    return {socket.name: socket.default_value for socket in node.inputs}


def links_of(obj):
    tree = obj.material_slots[0].material.node_tree
    return {(link.from_node.name, link.from_socket.name, link.to_node.name, link.to_socket.name) for link in tree.links}


@pytest.mark.parametrize(("window", "count"), [((0.0, 1.0), 13), ((0.25, 0.75), 5), ((-0.5, 0.55), 3), ((0.0, 1.0), 1)])
def test_stripes_are_where_even_levels_are(sheet, stripes, surface, tmp_path, window, count):
    sheet.dirichlet.count = count
    sheet.dirichlet.window_low, sheet.dirichlet.window_high = window
    node = stripes.add(sheet)
    step = (window[1] - window[0]) / count
    mask = render(sheet, node.outputs["Mask"], tmp_path / "mask.exr")
    assert_drawn(mask, surface.even_levels(*window, count), 0.15 * step / 2)


@pytest.mark.parametrize("phase", [0.3, 1.3, -0.2])
def test_phase_moves_stripes_by_steps_inside_the_window(sheet, stripes, tmp_path, phase):
    sheet.dirichlet.count = 4
    node = stripes.add(sheet)
    node.inputs["Phase"].default_value = phase
    shifted = (np.arange(-3, 7) + 0.5 + phase) / 4
    mask = render(sheet, node.outputs["Mask"], tmp_path / "mask.exr")
    assert_drawn(mask, shifted[(shifted > 0) & (shifted < 1)], 0.15 / 8)


def test_stripes_at_the_window_ends_are_not_drawn(sheet, stripes, tmp_path):
    sheet.dirichlet.count = 4
    node = stripes.add(sheet)
    node.inputs["Phase"].default_value = 0.5
    mask = render(sheet, node.outputs["Mask"], tmp_path / "mask.exr")
    assert_drawn(mask, np.array([0.25, 0.5, 0.75]), 0.15 / 8)


def test_patches_painted_with_the_window_ends_stay_free_of_stripes(stripes, tmp_path):
    obj = painted_grid(columns=11)
    paint(obj, "left", [x + 11 * y for x in range(3) for y in range(7)])
    paint(obj, "right", [x + 11 * y for x in range(8, 11) for y in range(7)])
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    node = stripes.add(obj)
    node.inputs["Phase"].default_value = -0.49  # all but at the lower end
    node.inputs["Width"].default_value = 0.5
    mask = render(obj, node.outputs["Mask"], tmp_path / "mask.exr")
    assert mask[(_PLACES < 0.2) | (_PLACES > 0.8)].max() == 0
    assert mask.max() == 1


def test_levels_in_steps_have_stripes_at_the_same_values(sheet, stripes, surface, tmp_path):
    settings = sheet.dirichlet
    settings.levels_mode, settings.step, settings.phase = "STEP", 0.15, 0.4
    settings.window_low, settings.window_high = 0.1, 0.92
    node = stripes.add(sheet)
    mask = render(sheet, node.outputs["Mask"], tmp_path / "mask.exr")
    assert_drawn(mask, surface.stepped_levels(0.1, 0.92, 0.15, 0.4), 0.15 * 0.15 / 2)


def test_level_is_that_of_the_nearest_stripe(sheet, stripes, surface, tmp_path):
    sheet.dirichlet.count = 4
    node = stripes.add(sheet)
    levels = surface.even_levels(0, 1, 4)
    shown = render(sheet, node.outputs["Level"], tmp_path / "level.exr")
    assert np.allclose(shown, levels[np.abs(_PLACES[:, None] - levels).argmin(axis=1)], atol=1e-6)


def test_undefined_field_has_no_stripes(stripes, tmp_path):
    corners = [(x, y, 0.0) for x in (0, 1, 1.5, 2) for y in (0, 1)]
    obj = add(corners, [(0, 2, 3, 1), (4, 6, 7, 5)])
    paint(obj, "a", [0, 1], 0.0)
    paint(obj, "b", [2, 3], 1.0)
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    obj.dirichlet.count = 2
    node = stripes.add(obj)
    node.inputs["Width"].default_value, node.inputs["Softness"].default_value = 0.4, 0.1
    node.inputs["Phase"].default_value = -0.4  # a line next to the lower end, which NaN counts as once clamped
    mask = render(obj, node.outputs["Mask"], tmp_path / "mask.exr", width=2.0)
    assert mask[_PLACES > 0.5].tolist() == [0] * (_PIXELS // 2)
    assert mask[:200].max() == 1


def test_soft_edge_fades_over_its_width(sheet, stripes, tmp_path):
    sheet.dirichlet.count = 1
    node = stripes.add(sheet)
    node.inputs["Width"].default_value, node.inputs["Softness"].default_value = 0.4, 0.2
    mask = render(sheet, node.outputs["Mask"], tmp_path / "mask.exr")
    expected = np.clip((0.2 - np.abs(_PLACES - 0.5)) / 0.2 + 0.5, 0, 1)
    assert np.abs(mask - expected).max() < 2 / _PIXELS / 0.2


def test_stripes_lie_over_the_ramp_in_their_color(sheet, stripes, tmp_path):
    sheet.dirichlet.count = 2
    stripes.add(sheet)
    stripes.find_color(sheet).default_value = (1, 0, 1, 1)
    mix = sheet.material_slots[0].material.node_tree.nodes["Dirichlet Stripe Color"]
    red = render(sheet, next(socket for socket in mix.outputs if socket.enabled), tmp_path / "color.exr")
    assert red[[100, 300]].tolist() == [1, 1]
    assert red[200] < 0.1  # the rainbow is green there


def test_adding_twice_adds_nothing_and_keeps_the_settings(sheet):
    assert bpy.ops.dirichlet.add_stripes() == {"FINISHED"}
    tree = sheet.material_slots[0].material.node_tree
    tree.nodes["Dirichlet Stripes"].inputs["Width"].default_value = 0.5
    counts, nodes, links = data_counts(), tree.nodes.keys(), links_of(sheet)
    assert bpy.ops.dirichlet.add_stripes() == {"FINISHED"}
    assert (data_counts(), tree.nodes.keys(), links_of(sheet)) == (counts, nodes, links)
    assert tree.nodes["Dirichlet Stripes"].inputs["Width"].default_value == 0.5


def test_removing_leaves_the_material_as_it_was(sheet):
    tree = sheet.material_slots[0].material.node_tree
    counts, nodes, links = data_counts(), tree.nodes.keys(), links_of(sheet)
    assert bpy.ops.dirichlet.add_stripes() == {"FINISHED"}
    assert links_of(sheet) != links
    assert bpy.ops.dirichlet.remove_stripes() == {"FINISHED"}
    assert (data_counts(), tree.nodes.keys(), links_of(sheet)) == (counts, nodes, links)


def test_matching_takes_the_levels_of_the_isolines_and_nothing_else(sheet, stripes):
    node = stripes.add(sheet)
    node.inputs["Width"].default_value = 0.5
    sheet.dirichlet.count = 7
    sheet.dirichlet.window_low = 0.25
    assert bpy.ops.dirichlet.match_stripes() == {"FINISHED"}
    shown = inputs_of(node)
    assert shown == {"Low": 0.25, "High": 1.0, "Count": 7.0, "Phase": 0.0, "Width": 0.5, "Softness": 0.0}


def test_solving_again_keeps_the_stripes(sheet, stripes):
    stripes.add(sheet).inputs["Width"].default_value = 0.5
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert stripes.find(sheet).inputs["Width"].default_value == 0.5


def test_other_materials_and_objects_are_left_alone(sheet, stripes):
    wood = bpy.data.materials.new("wood")
    if bpy.app.version < (5, 0, 0):
        wood.use_nodes = True  # later materials always do
    nodes = wood.node_tree.nodes.keys()
    bpy.ops.object.duplicate()
    copy = bpy.context.active_object
    stripes.add(copy)
    assert stripes.find(sheet) is None
    assert stripes.find(copy) is not None
    assert wood.node_tree.nodes.keys() == nodes
    stripes.add(sheet)
    assert stripes.find(sheet).node_tree == stripes.find(copy).node_tree
    stripes.remove(copy)
    assert stripes.find(sheet).node_tree.name == "Dirichlet Stripes"


def test_node_group_of_the_same_name_is_not_taken_for_ours(sheet, stripes):
    other = bpy.data.node_groups.new("Dirichlet Stripes", "ShaderNodeTree")
    assert stripes.add(sheet).node_tree != other


def test_levels_that_are_listed_are_refused(sheet):
    sheet.dirichlet.levels_mode, sheet.dirichlet.levels_list = "LIST", "0.1, 0.5"
    assert_refused(bpy.ops.dirichlet.add_stripes, sheet, "evenly spaced, the levels of object 'Grid' are not")


def test_stripes_undo_and_redo(sheet, stripes):
    bpy.ops.ed.undo_push(message="solved")
    counts, links = data_counts(), links_of(sheet)
    assert bpy.ops.dirichlet.add_stripes("EXEC_DEFAULT", True) == {"FINISHED"}
    added = links_of(sheet)
    bpy.ops.ed.undo()
    assert (data_counts(), links_of(bpy.data.objects["Grid"])) == (counts, links)
    bpy.ops.ed.redo()
    assert links_of(bpy.data.objects["Grid"]) == added


def test_stripes_survive_saving_and_their_phase_can_be_animated(sheet, stripes, tmp_path):
    phase = stripes.add(sheet).inputs["Phase"]
    for frame, value in ((1, 0.0), (11, 1.0)):
        phase.default_value = value
        assert phase.keyframe_insert("default_value", frame=frame)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    node = stripes.find(bpy.data.objects["Grid"])
    bpy.context.scene.frame_set(6)
    assert inputs_of(node)["Phase"] == pytest.approx(0.5)
    assert inputs_of(node)["Count"] == 13
