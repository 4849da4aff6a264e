# SPDX-License-Identifier: GPL-3.0-or-later
"""What a user may do next, at random. Each takes the source of chance, and leaves an undo step where Blender would."""

from contextlib import suppress
from random import Random

import bmesh
import bpy
import dirichlet_isolines
import hand
import numpy as np
import screen
from canvas import add_ball, ball, go_to, paint_with, stroke
from steps import Waiting, pictures

_FILE = str(pictures / "soak.blend")


def prepare() -> Waiting:
    """A new ball with two patches, followed."""
    yield from add_ball()
    for k, x in enumerate((-0.8, 0.8)):
        ball().vertex_groups.new(name=f"patch {k}").add(_disc((x, -0.6, 0), 0.3), 1.0, "REPLACE")
        with screen.at():
            bpy.ops.dirichlet.patch_add_group(group=f"patch {k}")
    settings = ball().dirichlet
    settings.overlap = "first"
    settings.live = settings.preview = True
    push("prepare")


def push(name: str) -> None:
    with screen.at():
        bpy.ops.ed.undo_push(message=name)


def paint(chance: Random) -> Waiting:
    go_to("WEIGHT_PAINT")
    obj = ball()
    obj.vertex_groups.active_index = chance.randrange(len(obj.vertex_groups))
    paint_with(chance.choice((1, 1, 0)))
    yield 0.1
    yield from stroke(*((chance.uniform(-0.6, 0.6), chance.uniform(-0.6, 0.6)) for _ in range(2)))


def paint_by_script(chance: Random) -> Waiting:
    leave_edit_mode()
    center = [chance.uniform(-1, 1) for _ in range(3)]
    group = ball().vertex_groups[chance.randrange(2)]
    group.add(_disc(center, chance.uniform(0.05, 0.3)), chance.choice((1.0, 0.6, 0.0)), "REPLACE")
    push("paint by script")
    yield 0


def undo(chance: Random) -> Waiting:
    yield from _key("ctrl+z", chance)


def redo(chance: Random) -> Waiting:
    yield from _key("ctrl+shift+z", chance)


def _key(keys: str, chance: Random) -> Waiting:
    view = screen.region("WINDOW")
    yield from hand.move((view.x + view.width // 2, view.height // 2))
    for _ in range(chance.randint(1, 3)):
        yield from hand.press(keys)
    if not any(obj.type == "MESH" for obj in bpy.data.objects):
        yield from prepare()


def set_lines(chance: Random) -> Waiting:
    settings = ball().dirichlet
    choices = {
        "count": chance.randint(1, 60),
        "phase": chance.random(),
        "step": chance.uniform(0.02, 0.5),
        "window_low_place": chance.random(),
        "window_high_place": chance.random(),
        "levels_mode": chance.choice(("EVEN", "STEP")),
        "window_auto": chance.random() < 0.5,
        "bevel_depth": chance.uniform(0, 0.01),
    }
    name = chance.choice(sorted(choices))
    setattr(settings, name, choices[name])
    push(name)
    yield 0


def slide(chance: Random) -> Waiting:
    """A window's end, over and over, as a mouse does."""
    name = chance.choice(("window_low_place", "window_high_place"))
    for place in np.linspace(chance.random(), chance.random(), 10).tolist():
        setattr(ball().dirichlet, name, place)
        yield 0.01
    push("slide")


def set_patch(chance: Random) -> Waiting:
    patch = chance.choice(ball().dirichlet.patches)
    if chance.random() < 0.7:
        patch.value = chance.uniform(-2, 2)
    else:
        patch.enabled = not patch.enabled
    push("patch")
    yield 0


def set_ramp(chance: Random) -> Waiting:
    ball().dirichlet.ramp_preset = chance.choice(("rainbow", "viridis", "grey", "red-blue"))
    push("ramp")
    yield 0


def switch_mode(chance: Random) -> Waiting:
    go_to(chance.choice(("OBJECT", "EDIT", "WEIGHT_PAINT", "VERTEX_PAINT", "SCULPT")))
    yield 0.1


def switch_live(chance: Random) -> Waiting:
    name = chance.choice(("live", "preview"))
    setattr(ball().dirichlet, name, not getattr(ball().dirichlet, name))
    push(name)
    yield 0


def make_isolines(chance: Random) -> Waiting:
    leave_edit_mode()
    with screen.at():
        if bpy.ops.dirichlet.make_isolines.poll():
            with suppress(RuntimeError):  # refused, in a sentence; were it a bug, its traceback is in the log
                bpy.ops.dirichlet.make_isolines("EXEC_DEFAULT", True)
    yield 0


def remove_isolines(chance: Random) -> Waiting:
    for obj in [obj for obj in bpy.data.objects if obj.type == "CURVE"]:
        bpy.data.objects.remove(obj)
    push("remove isolines")
    yield 0


def dent(chance: Random) -> Waiting:
    """The same faces elsewhere."""
    leave_edit_mode()
    for vertex in ball().data.vertices:
        vertex.co.z *= chance.choice((0.99, 1.01))
    ball().data.update()
    push("dent")
    yield 0


def remove_a_face(chance: Random) -> Waiting:
    """Other faces."""
    leave_edit_mode()
    mesh = ball().data
    editor = bmesh.new()
    editor.from_mesh(mesh)
    editor.faces.ensure_lookup_table()
    bmesh.ops.delete(editor, geom=[editor.faces[chance.randrange(len(editor.faces))]], context="FACES_ONLY")
    editor.to_mesh(mesh)
    editor.free()
    mesh.update()
    push("remove a face")
    yield 0


def rename(chance: Random) -> Waiting:
    obj = ball()
    chance.choice((obj, obj.data)).name = f"name {chance.randrange(1000)}"
    push("rename")
    yield 0


def remove(chance: Random) -> Waiting:
    yield from prepare()


def save(chance: Random) -> Waiting:
    with screen.at():
        bpy.ops.wm.save_as_mainfile(filepath=_FILE, check_existing=False)
    yield 0


def load(chance: Random) -> Waiting:
    yield from save(chance)
    with screen.at():
        bpy.ops.wm.open_mainfile(filepath=_FILE)
    yield 0.3


def change_frame(chance: Random) -> Waiting:
    bpy.context.scene.frame_set(chance.randint(1, 250))
    yield 0


def play(chance: Random) -> Waiting:
    for seconds in (0.5, 0):
        with screen.at():
            bpy.ops.screen.animation_play()
        yield seconds


def disable_and_enable(chance: Random) -> Waiting:
    for switch in (bpy.ops.preferences.addon_disable, bpy.ops.preferences.addon_enable):
        with screen.at():
            switch(module=dirichlet_isolines.__name__)
        yield chance.choice((0, 0.3))


def leave_edit_mode() -> None:
    if ball().mode == "EDIT":
        go_to("OBJECT")


def _disc(center: tuple[float, float, float], radius: float) -> list[int]:
    """The vertices of the ball near the direction of the center."""
    positions = np.array([vertex.co for vertex in ball().data.vertices])
    far = np.linalg.norm(positions - np.array(center) / np.linalg.norm(center), axis=1)
    return np.flatnonzero(far < radius).tolist()


WEIGHTS = {
    paint: 4, paint_by_script: 8, undo: 4, redo: 2, set_lines: 6, slide: 3, set_patch: 5, set_ramp: 2, switch_mode: 3,
    switch_live: 1, make_isolines: 2, remove_isolines: 1, dent: 1, remove_a_face: 1, rename: 2, remove: 1, save: 1,
    load: 1, change_frame: 2, play: 1, disable_and_enable: 1,
}  # fmt: skip
