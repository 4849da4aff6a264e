# SPDX-License-Identifier: GPL-3.0-or-later
"""Live and Preview in more than one window, while windows come and go, and while the add-on does."""

import actions
import bpy
import dirichlet_isolines
import screen
from canvas import ball
from dirichlet_isolines.blender import live
from steps import Waiting, run, until
from truth import is_fresh

_painted = iter(range(100, 10_000, 100))  # vertices still to paint


def second_window() -> Waiting:
    yield from actions.prepare()
    with screen.at():
        bpy.ops.wm.window_new_main()  # the other kind shows the scene of its parent
    yield 1
    assert len(bpy.context.window_manager.windows) == 2
    yield from _follows()


def another_scene_in_it() -> Waiting:
    """Its depsgraph knows nothing of the ball."""
    second = bpy.context.window_manager.windows[1]
    second.scene = bpy.data.scenes.new("Other")
    yield 1
    yield from _follows()
    second.scene.frame_set(2)
    yield from _follows()
    second.scene = screen.window().scene


def second_window_closed() -> Waiting:
    _paint()
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[1]):
        bpy.ops.wm.window_close()
    yield 1
    assert len(bpy.context.window_manager.windows) == 1
    yield from _is_current()


def disabled_and_enabled_again() -> Waiting:
    with screen.at():
        bpy.ops.preferences.addon_disable(module=dirichlet_isolines.__name__)
    _paint()
    yield 1
    assert not hasattr(bpy.types.Object, "dirichlet")
    with screen.at():
        bpy.ops.preferences.addon_enable(module=dirichlet_isolines.__name__)
    yield 1
    assert ball().dirichlet.live
    yield from _follows()


def _follows() -> Waiting:
    _paint()
    yield 0.3
    yield from _is_current()


def _paint() -> None:
    ball().vertex_groups["patch 0"].add([next(_painted)], 1.0, "REPLACE")
    ball().data.update()


def _is_current() -> Waiting:
    yield from until(lambda: not live.is_pending(ball()) and is_fresh(ball()), 20)
    assert live.preview_of(ball())


run(second_window, another_scene_in_it, second_window_closed, disabled_and_enabled_again)
