# SPDX-License-Identifier: GPL-3.0-or-later
"""Results with Follow change with field, settings, shape and frame. Without a window no timer runs, so tests flush."""

import importlib

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import field_of, paint, painted_grid

COLUMNS = 9  # the field is x / 8


@pytest.fixture
def live(addon):
    return importlib.import_module(f"{addon.__name__}.blender.live")


@pytest.fixture
def sheet():
    """A solved grid whose isolines follow."""
    obj = painted_grid(columns=COLUMNS)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    obj.dirichlet.isolines.dirichlet_isolines.follow = True
    return obj


def settle(live):
    bpy.context.view_layer.update()
    live.flush()


def levels(result):
    return list(result.data["dirichlet_level"])


def points(result):
    """(P, 3) of all splines."""
    return np.array([point.co[:3] for spline in result.data.splines for point in spline.points], np.float32)


def add_shape_key(obj, value=1.0):
    """Raises every vertex by x y / 8; returns the key."""
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Bent")
    for vertex, item in zip(obj.data.vertices, key.data, strict=True):
        item.co.z = vertex.co.x * vertex.co.y / 8
    key.value = value
    return key


def add_wave(obj):
    """A modifier that keeps the faces."""
    modifier = obj.modifiers.new("Bend", "SIMPLE_DEFORM")
    modifier.deform_method, modifier.angle, modifier.deform_axis = "BEND", 1.0, "Z"


def points_on_shape(surface, obj):
    """What the library extracts from the mesh as Blender shows it."""
    mesh = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    positions = [tuple(vertex.co) for vertex in mesh.vertices]
    shape = surface.Mesh(positions, np.array([tuple(polygon.vertices) for polygon in mesh.polygons]))
    return surface.isolines(shape, field_of(obj), surface.even_levels(0, 1, obj.dirichlet.count)).points


def another(obj, text):
    """A second result of the object, with these levels of its own."""
    first = obj.dirichlet.isolines
    first.dirichlet_isolines.locked = True
    bpy.ops.dirichlet.make_isolines()
    second = obj.dirichlet.isolines
    second.parent = None
    obj.dirichlet.isolines = first
    first.dirichlet_isolines.locked = False
    second.dirichlet_isolines.levels_mode, second.dirichlet_isolines.levels_list = "LIST", text
    return second


def test_settings_are_followed(live, sheet):
    sheet.dirichlet.count = 3
    settle(live)
    assert len(levels(sheet.dirichlet.isolines)) == 3


def test_a_new_field_is_followed(live, sheet):
    sheet.dirichlet.patches[1].value = 2.0
    bpy.ops.dirichlet.solve_field()
    settle(live)
    assert np.allclose(levels(sheet.dirichlet.isolines), 2 * (np.arange(13) + 0.5) / 13)


def test_results_of_one_source_follow_each_by_its_settings(live, sheet):
    second = another(sheet, "0.25")
    second.dirichlet_isolines.follow = True
    settle(live)
    assert levels(second) == [0.25]
    second.dirichlet_isolines.levels_list = "0.75"
    settle(live)
    assert levels(second) == [0.75]
    sheet.dirichlet.count = 2
    settle(live)
    assert (levels(second), levels(sheet.dirichlet.isolines)) == ([0.75], [0.25, 0.75])


@pytest.mark.parametrize("still", ["follow", "locked"])
def test_results_that_do_not_follow_stay(live, sheet, still):
    second = another(sheet, "0.25")
    second.dirichlet_isolines.follow = still != "follow"
    settle(live)
    before = levels(second)
    second.dirichlet_isolines.locked = still == "locked"
    second.dirichlet_isolines.levels_list = "0.75"
    sheet.dirichlet.count = 2
    settle(live)
    assert (levels(second), len(levels(sheet.dirichlet.isolines))) == (before, 2)


def test_following_answers_no_write_of_its_own(live, sheet):
    sheet.dirichlet.count = 3
    settle(live)
    for _ in range(3):
        bpy.context.view_layer.update()
        assert not live.is_pending(sheet)


def test_what_cannot_be_drawn_is_said_and_leaves_the_lines(live, sheet):
    sheet.dirichlet.count = 0
    settle(live)
    assert "0" in sheet.dirichlet.results.problem
    assert len(levels(sheet.dirichlet.isolines)) == 13


@pytest.mark.parametrize("bend", [add_shape_key, add_wave])
def test_lines_follow_the_deformed_surface(live, surface, sheet, bend):
    flat = points(sheet.dirichlet.isolines)
    bend(sheet)
    settle(live)
    bent = points(sheet.dirichlet.isolines)
    assert np.abs(bent - flat).max() > 0.1
    assert np.allclose(bent, points_on_shape(surface, sheet), atol=1e-5)


def test_make_isolines_draws_what_follows_on_the_deformed_surface(live, surface, sheet):
    add_shape_key(sheet)
    bpy.ops.dirichlet.make_isolines()
    assert np.allclose(points(sheet.dirichlet.isolines), points_on_shape(surface, sheet), atol=1e-5)


def test_without_follow_lines_lie_on_the_mesh_itself(sheet):
    flat = points(sheet.dirichlet.isolines)
    add_shape_key(sheet)
    sheet.dirichlet.isolines.dirichlet_isolines.follow = False
    bpy.ops.dirichlet.make_isolines()
    assert np.array_equal(points(sheet.dirichlet.isolines), flat)


def test_modifiers_that_make_other_faces_are_not_followed(live, sheet):
    flat = points(sheet.dirichlet.isolines)
    sheet.modifiers.new("Subdivision", "SUBSURF")
    add_shape_key(sheet)
    settle(live)
    assert np.array_equal(points(sheet.dirichlet.isolines), flat)


def test_preview_follows_the_deformed_surface(live, surface, sheet):
    sheet.dirichlet.preview = True
    add_shape_key(sheet)
    settle(live)
    assert np.allclose(live.preview_of(sheet).lines.points, points_on_shape(surface, sheet), atol=1e-5)


def test_undo_is_followed(live, sheet):
    bpy.ops.ed.undo_push(message="before")
    sheet.dirichlet.count = 3
    bpy.ops.ed.undo_push(message="count")
    settle(live)
    bpy.ops.ed.undo()
    settle(live)
    assert len(levels(bpy.data.objects["Grid"].dirichlet.isolines)) == 13


def test_a_reloaded_file_goes_on_following(live, sheet, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    sheet = bpy.data.objects["Grid"]
    sheet.dirichlet.count = 3
    settle(live)
    assert len(levels(sheet.dirichlet.isolines)) == 3


def animate(obj):
    """Phase, window, thickness of the lines' low end and the shape, from frame 1 to 3."""
    key, settings = add_shape_key(obj), obj.dirichlet
    settings.levels_mode, settings.step = "STEP", 0.25
    settings.window_low, settings.window_high = 0.0, 1.0
    for frame, phase, high, value in ((1, 0.0, 1.0, 0.0), (3, 0.5, 0.7, 1.0)):
        settings.phase, settings.window_high, key.value = phase, high, value
        settings.keyframe_insert("phase", frame=frame)
        settings.keyframe_insert("window_high", frame=frame)
        key.keyframe_insert("value", frame=frame)


def test_every_frame_has_the_lines_that_make_isolines_draws(live, surface, sheet):
    animate(sheet)
    for frame, expected in ((1, [0.25, 0.5, 0.75]), (2, [0.0625, 0.3125, 0.5625, 0.8125]), (3, [0.125, 0.375, 0.625])):
        bpy.context.scene.frame_set(frame)
        followed = levels(sheet.dirichlet.isolines), points(sheet.dirichlet.isolines)
        assert np.allclose(followed[0], expected)
        bpy.ops.dirichlet.make_isolines()
        assert levels(sheet.dirichlet.isolines) == followed[0]
        assert np.array_equal(points(sheet.dirichlet.isolines), followed[1])


def set_up_render(folder):
    scene = bpy.context.scene
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(scene.camera)
    scene.camera.data.type, scene.camera.data.ortho_scale, scene.camera.location = "ORTHO", 10, (4, 3, 10)
    scene.render.engine, scene.render.film_transparent = "CYCLES", True
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.device = 1, False, "CPU"
    scene.render.resolution_x = scene.render.resolution_y = 64
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = f"{folder}/"
    scene.frame_start, scene.frame_end = 1, 3


def picture(path):
    image = bpy.data.images.load(str(path))
    pixels = np.array(image.pixels[:])
    bpy.data.images.remove(image)
    return pixels


def test_a_rendered_animation_has_the_lines_of_every_frame(sheet, tmp_path):
    animate(sheet)
    sheet.dirichlet.bevel_depth, sheet.hide_render = 0.02, True
    set_up_render(tmp_path)
    rendered = []
    note = bpy.app.handlers.render_post.append
    note(lambda *_: rendered.append((levels(sheet.dirichlet.isolines), points(sheet.dirichlet.isolines))))
    try:
        bpy.ops.render.render(animation=True)
    finally:
        bpy.app.handlers.render_post.pop()
    pictures = [picture(tmp_path / f"000{frame}.png") for frame in (1, 2, 3)]
    for frame in (1, 2, 3):
        bpy.context.scene.frame_set(frame)
        bpy.ops.dirichlet.make_isolines()
        assert levels(sheet.dirichlet.isolines) == rendered[frame - 1][0]
        assert np.array_equal(points(sheet.dirichlet.isolines), rendered[frame - 1][1])
        bpy.context.scene.render.filepath = str(tmp_path / "still.png")
        bpy.ops.render.render(write_still=True)
        assert np.array_equal(picture(tmp_path / "still.png"), pictures[frame - 1])
    assert not np.array_equal(pictures[0], pictures[1])
    assert not np.array_equal(pictures[1], pictures[2])


def test_a_rendered_animation_solves_for_animated_values_while_live(sheet, tmp_path):
    sheet.dirichlet.live = True
    patch = sheet.dirichlet.patches[1]
    for frame, value in ((1, 1.0), (3, 3.0)):
        patch.value = value
        patch.keyframe_insert("value", frame=frame)
    set_up_render(tmp_path)
    highest = []
    bpy.app.handlers.render_post.append(lambda *_: highest.append(float(field_of(sheet).max())))
    try:
        bpy.ops.render.render(animation=True)
    finally:
        bpy.app.handlers.render_post.pop()
    assert highest == [1, 2, 3]


class TestUseModifiers:
    def test_isolines_lie_on_the_evaluated_mesh(self, surface):
        obj = painted_grid(columns=COLUMNS)
        obj.dirichlet.use_modifiers = True
        add_wave(obj)
        bpy.ops.dirichlet.solve_field()
        bpy.ops.dirichlet.make_isolines()
        assert np.ptp(points(obj.dirichlet.isolines)[:, 1]) > 0
        assert np.allclose(points(obj.dirichlet.isolines), points_on_shape(surface, obj), atol=1e-5)

    def test_weights_are_those_that_modifiers_leave(self):
        obj = painted_grid(columns=COLUMNS)
        modifier = obj.modifiers.new("Half", "VERTEX_WEIGHT_EDIT")
        modifier.vertex_group, modifier.falloff_type = "right", "LINEAR"
        modifier.use_remove, modifier.remove_threshold = True, 1.0
        modifier.mask_constant = 1.0
        obj.vertex_groups["right"].add([8], 0.6, "REPLACE")
        bpy.ops.dirichlet.solve_field()
        assert field_of(obj)[8] == 1
        obj.dirichlet.use_modifiers = True
        bpy.ops.dirichlet.solve_field()
        assert field_of(obj)[8] < 1
        assert not [mesh.name for mesh in bpy.data.meshes if mesh != obj.data]

    @pytest.mark.parametrize("operator", ["solve_field", "make_isolines"])
    def test_other_faces_are_refused_with_both_counts(self, operator):
        obj = painted_grid(columns=COLUMNS)
        bpy.ops.dirichlet.solve_field()
        obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
        obj.dirichlet.use_modifiers = True
        sentence = "modifiers of object 'Grid' make 221 vertices and 192 faces of the 63 vertices and 48 faces"
        assert_refused(getattr(bpy.ops.dirichlet, operator), obj, sentence)

    def test_live_says_so_too(self, live):
        obj = painted_grid(columns=COLUMNS)
        obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
        obj.dirichlet.live, obj.dirichlet.use_modifiers = True, True
        paint(obj, "left", [12])
        settle(live)
        assert "221 vertices" in obj.dirichlet.results.problem
