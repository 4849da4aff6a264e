# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/guide.md tells, done step by step; ../guide_pictures.py makes its pictures of what is seen here."""

import math

import bpy
import hand
import scene
import screen
from canvas import ball as head
from canvas import go_to, paint_with, stroke
from dirichlet_isolines.blender import live
from steps import Waiting, pictures, run, until

PLACES = ((-1.15, 0.25), (1.15, 0.25), (0.0, 0.75))  # both ears and the forehead, as x and z


def install() -> Waiting:
    bpy.context.preferences.system.viewport_aa = "8"
    bpy.context.preferences.active_section = "ADDONS"
    bpy.context.window_manager.addon_search = "Dirichlet"
    with screen.at():
        bpy.ops.screen.userpref_show()
    yield 2


def model() -> Waiting:
    """Blender's monkey as one closed surface of faces that are all of a size."""
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[-1]):
        bpy.ops.wm.window_close()
    bpy.ops.object.delete()
    with screen.at():
        bpy.ops.mesh.primitive_monkey_add()
        for kind, setting, value in (
            ("SUBSURF", "levels", 3),
            ("REMESH", "voxel_size", 0.025),
            ("SMOOTH", "iterations", 4),
        ):
            setattr(head().modifiers.new(kind, kind), setting, value)
            bpy.ops.object.modifier_apply(modifier=kind)
        bpy.ops.object.shade_smooth()
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_selected()
        bpy.ops.ed.undo_push(message="Model")
    overlay = screen.viewport().spaces.active.overlay
    overlay.show_ortho_grid = overlay.show_axis_x = overlay.show_axis_z = False  # pictures are smaller without
    yield 1


def first_field() -> Waiting:
    yield from hand.move(screen.pixel_of((0, 0, 0)))
    yield from hand.press("n")
    yield from screen.open_tab(bpy.types.DIRICHLET_PT_patches)
    yield from screen.press("tool_set_by_id")
    for x, z in PLACES:
        right, down = screen.pixel_of((x, 0, z))
        yield from hand.drag(hand.line((right, down), (right + 40, down)), 0.3)
    yield from screen.press("solve_field", 0.3)
    yield 1


def preview_and_window() -> Waiting:
    settings = head().dirichlet
    yield from screen.press("preview", 0.22, 0.17)
    settings.count, settings.legend = 24, True
    x, y = yield from screen.find("window_low_place", 0.2)
    yield from hand.drag(hand.line((x, y), (x + 30, y)), 0.2)
    x, y = yield from screen.find("window_high_place", 0.8)
    yield from hand.drag(hand.line((x, y), (x - 50, y)), 0.2)
    yield 1


def live_painting() -> Waiting:
    settings = head().dirichlet
    settings.window_auto, settings.legend = True, False
    yield from screen.press("live", 0.7)
    settings.active_patch = 0
    with screen.at():
        bpy.ops.dirichlet.patch_paint()
        bpy.ops.wm.tool_set_by_id(name="builtin_brush.Draw")
    paint_with(1)
    screen.viewport().spaces.active.overlay.weight_paint_mode_opacity = 0.4
    yield 1
    yield from stroke((-0.15, -0.4), (-0.15, -0.8))
    yield from stroke((0.5, -0.05), (0.75, 0.2))
    yield from until(lambda: not live.is_pending(head()))
    yield 1


def result() -> Waiting:
    go_to("OBJECT")
    settings = head().dirichlet
    settings.preview = False
    settings.levels_mode, settings.step, settings.bevel_depth = "STEP", 0.1, 0.003
    yield from screen.press("make_isolines")
    settings.isolines.dirichlet_isolines.follow = True
    _activate(settings.isolines)
    with screen.at():
        bpy.ops.wm.tool_set_by_id(name="builtin.select_box")
    screen.viewport().spaces.active.overlay.show_outline_selected = False
    yield 1


def animation() -> Waiting:
    """One phase in 24 frames: a loop in which every line moves to its neighbour."""
    settings = head().dirichlet
    settings.live = False  # it would show the field's material again
    yield 1
    for frame, phase in ((1, 0.0), (25, 1.0)):
        settings.phase = phase
        settings.keyframe_insert("phase", frame=frame)
    _set_studio()
    slot = head().material_slots[0]
    field, slot.material = slot.material, bpy.data.materials.new("Clay")
    for frame in (1, 9, 17):
        bpy.context.scene.frame_set(frame)
        _render(f"frame-{frame:02}")
        yield 0.1
    slot.material = field


def stripes() -> Waiting:
    settings = head().dirichlet
    head().animation_data_clear()
    settings.isolines.hide_render = True
    settings.levels_mode, settings.count = "EVEN", 24
    _activate(head())
    with screen.at():
        bpy.ops.dirichlet.add_stripes()
    _render("stripes")
    yield 1


def uneven_faces() -> Waiting:
    """A strip of faces that are small on the left: lines by neighbors alone, then by the shape."""
    for obj in (head(), head().dirichlet.isolines):
        obj.hide_render = True
    strip, edges = _uneven_strip(), _showing_edges()
    _activate(strip)
    bpy.context.scene.camera.location, bpy.context.scene.camera.rotation_euler = (0, -3, 0), (math.pi / 2, 0, 0)
    bpy.context.scene.render.resolution_y = 140
    for laplacian in ("graph", "intrinsic_delaunay"):
        strip.dirichlet.laplacian = laplacian
        with screen.at():
            bpy.ops.dirichlet.solve_field()
            bpy.ops.dirichlet.make_isolines()
        strip.material_slots[0].material = edges
        _render(f"uneven-{laplacian}")
    yield 1


def _uneven_strip() -> bpy.types.Object:
    """Painted 0 and 1 at its ends."""
    across = [k / 24 - 1 for k in range(24)] + [k / 4 for k in range(5)]
    n = len(across)
    first = [x + n * z for z in range(4) for x in range(n - 1)]
    with screen.at():
        strip = scene.add(
            [(x, 0, z / 8 - 0.25) for z in range(5) for x in across], [(v, v + 1, v + n + 1, v + n) for v in first]
        )
    scene.paint(strip, "left", range(0, 5 * n, n), 0.0)
    scene.paint(strip, "right", range(n - 1, 5 * n, n), 1.0)
    strip.dirichlet.count, strip.dirichlet.bevel_depth = 15, 0.003
    return strip


def _showing_edges() -> bpy.types.Material:
    material = bpy.data.materials.new("Edges")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    edges, shades = nodes.new("ShaderNodeWireframe"), nodes.new("ShaderNodeValToRGB")
    edges.inputs["Size"].default_value = 0.006
    for shade, grey in zip(shades.color_ramp.elements, (0.7, 0.3)):
        shade.color = (grey, grey, grey, 1)
    links.new(edges.outputs[0], shades.inputs[0])
    links.new(shades.outputs[0], nodes["Principled BSDF"].inputs["Base Color"])
    return material


def _activate(obj: bpy.types.Object) -> None:
    with screen.at():
        bpy.ops.object.select_all(action="DESELECT")
        obj.select_set(True)
        bpy.context.view_layer.objects.active = obj


def _set_studio() -> None:
    studio = bpy.context.scene
    with screen.at():
        bpy.ops.object.camera_add(location=(0.5, -5, 0.6), rotation=(1.47, 0, 0.1))
        studio.camera = bpy.context.object
        bpy.ops.object.light_add(type="SUN", rotation=(0.8, 0.3, 0))
        bpy.context.object.data.energy = 2
    studio.render.engine, studio.cycles.samples, studio.cycles.use_denoising = "CYCLES", 32, False
    studio.view_settings.view_transform = "Standard"
    studio.render.resolution_x, studio.render.resolution_y = 480, 400


def _render(name: str) -> None:
    bpy.context.scene.render.filepath = str(pictures / f"{name}.png")
    bpy.ops.render.render(write_still=True)


run(install, model, first_field, preview_and_window, live_painting, result, animation, stripes, uneven_faces)
