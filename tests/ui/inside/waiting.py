# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh large enough to wait for: progress, Esc, undo, and the question before a very large one."""

import bpy
import dirichlet_isolines
import hand
import scene
import screen
from screen import forget_meshes, invoke, wait_for_nothing
from steps import Waiting, picture, run, until

BALL = "Ball"


def ball() -> bpy.types.Object:
    """Asked for anew in every step: undo replaces it."""
    return bpy.data.objects[BALL]


def is_solved() -> bool:
    return "dirichlet_field" in ball().data.attributes


def start() -> Waiting:
    wait_for_nothing()
    bpy.ops.object.delete()
    scene.painted_sphere(8, BALL)
    with screen.at():
        bpy.ops.view3d.view_selected()
    bpy.ops.ed.undo_push(message="painted")
    yield from hand.move(screen.pixel_of((0, 0, 0)))
    yield 1


def escape_drops_what_is_computed() -> Waiting:
    ball().dirichlet.method = "lscg"  # which takes very long
    assert invoke("solve_field") == {"RUNNING_MODAL"}
    yield 3
    yield from picture("computing")
    yield from hand.press("x")  # would delete the object, if it were listened to
    yield from hand.press("Escape")
    yield 2
    assert not is_solved()
    assert not ball().material_slots


def a_solver_that_was_dropped_holds_nobody_up() -> Waiting:
    ball().dirichlet.method = "auto"
    bpy.ops.ed.undo_push(message="method")
    assert invoke("solve_field") == {"RUNNING_MODAL"}
    yield from until(is_solved)
    assert invoke("make_isolines") == {"RUNNING_MODAL"}
    yield from until(lambda: ball().dirichlet.results.extracted)


def undo_goes_back_one_computation_at_a_time() -> Waiting:
    bpy.ops.ed.undo()
    yield 0.5
    assert is_solved()
    assert not bpy.data.curves
    bpy.ops.ed.undo()
    yield 0.5
    assert not is_solved()


def removing_the_object_meanwhile_is_survived() -> Waiting:
    forget_meshes()
    assert invoke("solve_field") == {"RUNNING_MODAL"}
    ball().name = "gone"
    bpy.data.objects.remove(bpy.data.objects["gone"])
    yield 3
    bpy.ops.ed.undo()
    yield 0.5
    assert not is_solved()


def a_very_large_mesh_is_asked_about() -> Waiting:
    bpy.context.preferences.addons[dirichlet_isolines.__name__].preferences.ask_vertices = 100_000
    assert invoke("solve_field") == {"CANCELLED"}
    yield 1
    yield from picture("question")
    assert not is_solved()
    yield from hand.press("Return")
    yield from until(is_solved)


run(
    start,
    escape_drops_what_is_computed,
    a_solver_that_was_dropped_holds_nobody_up,
    undo_goes_back_one_computation_at_a_time,
    removing_the_object_meanwhile_is_survived,
    a_very_large_mesh_is_asked_about,
)
