# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of four million vertices: whatever takes long shows how far it is, Esc ends it, and nothing has changed.

Borders are found before a picture is taken and Esc pressed: dropping them is tested without a window.
"""

import bpy
import dirichlet_isolines
import hand
import numpy as np
import scene
import screen
from screen import forget_meshes, invoke, wait_for_nothing
from steps import Waiting, finished, picture, run, until

SIDE = 2000  # vertices
SHEET = "Sheet"


def sheet() -> bpy.types.Object:
    """Asked for anew in every step: undo replaces it."""
    return bpy.data.objects[SHEET]


def make_sheet() -> bpy.types.Object:
    """A square of quads, its vertices in rows."""
    mesh = bpy.data.meshes.new(SHEET)
    x, y = np.meshgrid(np.linspace(-2, 2, SIDE, dtype=np.float32), np.linspace(-2, 2, SIDE, dtype=np.float32))
    corner = (np.arange(SIDE - 1) + SIDE * np.arange(SIDE - 1)[:, None]).reshape(-1, 1)
    quads = (corner + np.array([0, 1, SIDE + 1, SIDE])).astype(np.int32)
    mesh.vertices.add(SIDE * SIDE)
    mesh.loops.add(quads.size)
    mesh.polygons.add(len(quads))
    mesh.vertices.foreach_set("co", np.stack((x, y, np.zeros_like(x)), axis=-1).ravel())
    mesh.loops.foreach_set("vertex_index", quads.ravel())
    mesh.polygons.foreach_set("loop_start", np.arange(0, quads.size, 4, dtype=np.int32))
    if bpy.app.version < (4, 1):
        mesh.polygons.foreach_set("loop_total", np.full(len(quads), 4, np.int32))
    mesh.update(calc_edges=True)
    mesh.attributes.new("dirichlet_field", "FLOAT", "POINT").data.foreach_set("value", (x * x + y).ravel())
    mesh.attributes.new("islands", "INT", "POINT").data.foreach_set("value", (x > y).astype(np.int32).ravel())
    obj = scene.link(mesh, SHEET)
    obj.display_type = "BOUNDS"  # software would draw it for seconds
    return obj


def facts() -> tuple:
    obj = sheet()
    rows = [(row.group, row.vertices, row.problem) for row in obj.dirichlet.patches]
    return rows, list(obj.vertex_groups.keys()), len(bpy.data.curves), obj.dirichlet.levels_list


def start() -> Waiting:
    wait_for_nothing()
    bpy.ops.object.delete()
    obj = make_sheet()
    scene.paint(obj, "left", range(0, SIDE * SIDE, SIDE), 0.0)
    scene.paint(obj, "right", range(SIDE - 1, SIDE * SIDE, SIDE), 1.0)
    obj.dirichlet.levels_mode, obj.dirichlet.smooth = "EQUAL_AREA", 1000
    bpy.context.preferences.addons[dirichlet_isolines.__name__].preferences.ask_vertices = 10_000_000
    with screen.at():
        bpy.ops.view3d.view_axis(type="TOP")
        bpy.ops.view3d.view_selected()
    bpy.ops.ed.undo_push(message="sheet")
    yield 3
    yield from hand.move(screen.pixel_of((0.5, 0.5, 0)))


def escape(name: str, **properties) -> Waiting:
    """Begins the operator and presses Esc when it has shown itself: all is as it was, and stays so."""
    forget_meshes()
    before = facts()
    with screen.going_on():
        assert invoke(name, **properties) == {"RUNNING_MODAL"}, name
        yield from picture(name)
        yield from hand.press("Escape")
    assert facts() == before, name
    yield 1
    assert facts() == before, name


def escape_drops_solving() -> Waiting:
    yield from escape("solve_field")


def escape_drops_tracing() -> Waiting:
    yield from escape("make_isolines")


def escape_drops_checking() -> Waiting:
    yield from escape("check_patches")


def escape_drops_pieces() -> Waiting:
    yield from escape("patches_from_pieces")


def escape_drops_what_a_dialog_began() -> Waiting:
    before = facts()
    assert invoke("patches_from_attribute", attribute="islands") == {"RUNNING_MODAL"}
    yield 1
    with screen.going_on() as begun:
        yield from hand.press("Return")
        yield from until(begun)
        yield from picture("islands")
        yield from hand.press("Escape")
    assert facts() == before
    yield 1
    assert facts() == before


def escape_drops_the_first_press_of_add_patch() -> Waiting:
    forget_meshes()
    before = facts()
    with screen.at():
        bpy.ops.wm.tool_set_by_id(name="dirichlet.add_patch")
    yield 1
    with screen.going_on() as begun:
        yield from finished("xdotool", "mousemove", *screen.pixel_of((0.5, 0.5, 0)), "sleep", 0.3, "mousedown", 1)
        yield from until(begun)
        yield 0.5
        yield from picture("first-press")
        yield from hand.press("Escape")
    yield from finished("xdotool", "mouseup", 1)
    yield 1
    assert facts() == before


def the_press_after_it_adds_a_patch() -> Waiting:
    before = len(sheet().dirichlet.patches)
    yield from finished("xdotool", "mousemove", *screen.pixel_of((0.4, 0.5, 0)), "sleep", 0.3, "click", 1)
    yield from until(lambda: len(sheet().dirichlet.patches) == before + 1)
    bpy.ops.ed.undo()
    yield 1
    assert len(sheet().dirichlet.patches) == before


def what_is_not_cancelled_is_done() -> Waiting:
    forget_meshes()
    sheet().dirichlet.smooth, sheet().dirichlet.levels_mode = 0, "EVEN"
    assert invoke("patches_from_borders") == {"RUNNING_MODAL"}
    yield 0.5
    yield from picture("going-on")
    yield from until(lambda: len(sheet().dirichlet.patches) == 3)
    assert invoke("make_isolines") == {"RUNNING_MODAL"}
    yield from until(lambda: sheet().dirichlet.isolines)


def refresh_is_dropped_too() -> Waiting:
    sheet().dirichlet.smooth = 1000
    result = sheet().dirichlet.isolines
    points = len(result.data.splines[0].points)
    bpy.context.view_layer.objects.active = result
    yield from escape("result_refresh")
    assert len(sheet().dirichlet.isolines.data.splines[0].points) == points


run(
    start,
    escape_drops_solving,
    escape_drops_tracing,
    escape_drops_checking,
    escape_drops_pieces,
    escape_drops_what_a_dialog_began,
    escape_drops_the_first_press_of_add_patch,
    the_press_after_it_adds_a_patch,
    what_is_not_cancelled_is_done,
    refresh_is_dropped_too,
)
