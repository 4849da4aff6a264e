# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines that follow in an animation: at every frame, and in every frame that is rendered."""

import bpy
import numpy as np
import pytest
from archives import STAGED
from in_new_blender import run_blender, save
from scene import field_of, painted_grid
from shapes import add_shape_key, levels, points


@pytest.fixture
def sheet():
    """A solved grid, x / 8 on columns 0 to 8, whose isolines follow."""
    obj = painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    obj.dirichlet.isolines.dirichlet_isolines.follow = True
    return obj


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


def test_every_frame_has_the_lines_that_make_isolines_draws(sheet):
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


def test_a_saved_animation_is_rendered_by_a_blender_of_its_own(sheet, tmp_path):
    animate(sheet)
    sheet.dirichlet.bevel_depth, sheet.hide_render = 0.02, True
    set_up_render(tmp_path)
    path = save(tmp_path)
    bpy.ops.render.render(animation=True)
    here = [picture(tmp_path / f"000{frame}.png") for frame in (1, 2, 3)]
    run_blender(f"""
import bpy, importlib, sys
sys.path.insert(0, {str(STAGED.parent)!r})
importlib.import_module({STAGED.name!r}).register()
bpy.ops.wm.open_mainfile(filepath={str(path)!r})
bpy.context.scene.render.filepath = {str(tmp_path / "there")!r}
bpy.ops.render.render(animation=True)
""")
    there = [picture(tmp_path / f"there000{frame}.png") for frame in (1, 2, 3)]
    assert all(map(np.array_equal, here, there))
    assert not np.array_equal(there[0], there[2])


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
