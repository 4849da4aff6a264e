# SPDX-License-Identifier: GPL-3.0-or-later
"""Where things are in Blender's window, in pixels counted from its upper left corner."""

import re
from collections.abc import Callable, Generator, Iterator
from contextlib import AbstractContextManager, contextmanager
from unittest.mock import patch

import bpy
import hand
from bpy_extras.view3d_utils import location_3d_to_region_2d
from hand import Pixel
from mathutils import Vector
from steps import Waiting

_WHEEL_UP, _WHEEL_DOWN = 4, 5  # buttons of the mouse
_seen: dict[str, Pixel] = {}  # where a button was when it was last looked for


def window() -> bpy.types.Window:
    return bpy.context.window_manager.windows[0]


def viewport() -> bpy.types.Area:
    return max((area for area in window().screen.areas if area.type == "VIEW_3D"), key=lambda area: area.width)


def region(kind: str) -> bpy.types.Region:
    """Of the viewport: "WINDOW", or "UI" for its sidebar."""
    return next(found for found in viewport().regions if found.type == kind)


def at(kind: str = "WINDOW") -> AbstractContextManager:
    """The context of an operator called there: a timer has none."""
    return bpy.context.temp_override(window=window(), area=viewport(), region=region(kind))


def invoke(name: str, **properties) -> set[str]:
    """Calls one of the add-on's operators there, as its button would."""
    with at():
        return getattr(bpy.ops.dirichlet, name)("INVOKE_DEFAULT", True, **properties)


def pixel_of(point: tuple[float, float, float]) -> Pixel:
    """Where a point of the world is drawn."""
    view = region("WINDOW")
    place = location_3d_to_region_2d(view, viewport().spaces.active.region_3d, Vector(point))
    return round(view.x + place.x), round(window().height - view.y - place.y)


def open_tab(panel: type[bpy.types.Panel]) -> Waiting:
    """Clicks down the sidebar's tabs until the panel is drawn."""
    drawn = []
    notice = lambda panel, context: drawn.append(True)  # noqa: E731
    panel.append(notice)
    side = region("UI")
    for y in range(window().height - side.y - side.height + 20, window().height - side.y, 25):
        yield from hand.click((side.x + side.width - 8, y))
        if drawn:
            break
    panel.remove(notice)
    assert drawn, "no tab has the panel"


def find(name: str, *across: float) -> Generator[float, None, Pixel]:
    """Looks for a button in the sidebar, `across` of its width from the left (or there, where later Blenders have it),
    scrolling it to its end and back: an operator's or a property's name. The pixel is the generator's value."""
    for wheel in (None, *[_WHEEL_DOWN] * 3, *[_WHEEL_UP] * 3):
        side = region("UI")
        columns = [round(side.x + share * side.width) for share in across or (0.6,)]
        top = window().height - side.y - side.height
        if wheel:
            yield from hand.click((columns[0], top + side.height // 2), wheel, times=6)
        places = [(x, y) for x in columns for y in range(top + 4, top + side.height, 8)]
        for pixel in [_seen.get(name, places[0]), *places]:
            yield from hand.move(pixel)
            if re.search(rf"\b{name}\b", _under_pointer()):
                _seen[name] = pixel
                return pixel
    raise AssertionError(f"no button '{name}' in the sidebar")


def press(name: str, *across: float) -> Waiting:
    """Clicks a button of the sidebar: see `find`."""
    yield from hand.click((yield from find(name, *across)))


def _under_pointer() -> str:
    """What the button under the pointer would copy: its property's path, or its operator's call."""
    with at("UI"):
        for copy in (bpy.ops.ui.copy_python_command_button, bpy.ops.ui.copy_data_path_button):
            if copy.poll():
                copy()
                return bpy.context.window_manager.clipboard
    return ""


def forget_meshes() -> None:
    """So that the next work begins from nothing, and takes its time."""
    from dirichlet_isolines.blender.mesh import sessions

    sessions.forget_all()


def wait_for_nothing() -> None:
    """So that large meshes are worked on beside the interface however quick the machine is."""
    from dirichlet_isolines.ui import computing

    computing._PATIENCE = 0


@contextmanager
def going_on() -> Iterator[Callable[[], bool]]:
    """Work beside the interface is computed, but seen to be done only when the context has ended. Tells whether there
    is some."""
    from dirichlet_isolines.blender.work import Background

    with patch.object(Background, "poll", return_value=None) as poll:
        yield lambda: poll.called
