# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows when a property of Object.dirichlet or Object.dirichlet_isolines changes."""

from contextlib import suppress
from math import dist

import bpy

from .. import library
from . import viewport

_NARROWEST = 0.001  # window that sliders make, as a fraction of the ramp


def ramp_preset_changed(settings, context) -> None:
    settings.ramp_stops = ""


def ramp_stops_changed(settings, context) -> None:
    from ..blender import pipeline

    with suppress(library.LibraryMissingError), suppress(*library.refusals()):  # panel and operators say so
        pipeline.apply_look(settings.id_data)


def painting_changed(settings, context) -> None:
    from ..blender import live

    live.changed(settings.id_data, live.Change.FIELD | live.Change.LINES)


def lines_changed(settings, context) -> None:
    from ..blender import live
    from ..blender.lines import result_objects

    source = result_objects.drawn_by(settings)
    if source:
        live.changed(source, live.Change.LINES)


def is_other_mesh(note, obj) -> bool:
    return obj.type == "MESH" and obj != note.id_data


def follow_changed(note, context) -> None:
    """`followed` is never switched off: that would need to know of every result."""
    from ..blender import live

    if note.follow and note.source:
        note.source.dirichlet.followed = True
        live.changed(note.source, live.Change.LINES)


def live_changed(settings, context) -> None:
    painting_changed(settings, context)
    if settings.live:
        viewport.show_vertex_colors(context)
    _push_undo_while_painting("Live")


def preview_changed(settings, context) -> None:
    lines_changed(settings, context)
    _push_undo_while_painting("Preview")


def _push_undo_while_painting(step: str) -> None:
    """Blender 3 remembers no property that is set in a paint mode, so that undoing the next stroke would unset it."""
    if bpy.app.version < (4, 0) and not bpy.app.background and bpy.context.mode in ("PAINT_WEIGHT", "PAINT_VERTEX"):
        bpy.ops.ed.undo_push(message=step)


def bevel_depth_changed(settings, context) -> None:
    from ..blender.lines import result_drawing

    result_drawing.set_thickness(settings)


def get_patch_color(patch) -> tuple[float, float, float]:
    from ..blender.look import ramp

    return ramp.color_at(patch.id_data, patch.value)


def get_disc_radius(settings) -> float:
    return settings.disc_size * _box_diagonal(settings.id_data)


def set_disc_radius(settings, radius: float) -> None:
    settings.disc_size = radius / (_box_diagonal(settings.id_data) or 1.0)


def _box_diagonal(obj: bpy.types.Object) -> float:
    """In object space; known to Blender, while the mesh's own would be found anew at every redraw."""
    low, *_, high = sorted(map(tuple, obj.bound_box))
    return dist(low, high)


# The window follows the field's range until one of its ends is set; the other end then starts at that range's.


def window_auto_changed(settings, context) -> None:
    """Switched off before any end was ever set, the window starts as what it was."""
    ends = ("window_low", "window_high")
    if settings.results.solved and not (settings.window_auto or any(map(settings.is_property_set, ends))):
        settings.window_low, settings.window_high = settings.results.minimum, settings.results.maximum
    lines_changed(settings, context)


def window_low_changed(settings, context) -> None:
    if settings.window_auto:
        settings.window_auto = False
        settings.window_high = settings.results.maximum
    lines_changed(settings, context)


def window_high_changed(settings, context) -> None:
    if settings.window_auto:
        settings.window_auto = False
        settings.window_low = settings.results.minimum
    lines_changed(settings, context)


def get_window_low_place(settings) -> float:
    return 0.0 if settings.window_auto else _place(settings, settings.window_low)


def get_window_high_place(settings) -> float:
    return 1.0 if settings.window_auto else _place(settings, settings.window_high)


def set_window_low_place(settings, place: float) -> None:
    """Stops before the other end, since an empty window has no levels."""
    settings.window_low = _value(settings, min(place, get_window_high_place(settings) - _NARROWEST))


def set_window_high_place(settings, place: float) -> None:
    settings.window_high = _value(settings, max(place, get_window_low_place(settings) + _NARROWEST))


def get_window_place(settings) -> float:
    """Of the window among those of its width: 0 at the left end of the ramp, 1 at the right end."""
    low, high = get_window_low_place(settings), get_window_high_place(settings)
    free = 1.0 - (high - low)
    return low / free if free > 0 else 0.5


def set_window_place(settings, place: float) -> None:
    low, high = get_window_low_place(settings), get_window_high_place(settings)
    start = place * (1.0 - (high - low))
    if high - low < 1.0:
        settings.window_low, settings.window_high = _value(settings, start), _value(settings, start + (high - low))


def _place(settings, value: float) -> float:
    """On the ramp, from 0 to 1."""
    low, high = settings.results.minimum, settings.results.maximum
    return min(max((value - low) / (high - low), 0.0), 1.0) if high > low else 0.5


def _value(settings, place: float) -> float:
    low, high = settings.results.minimum, settings.results.maximum
    return low + place * (high - low)
