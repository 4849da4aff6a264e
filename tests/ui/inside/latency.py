# SPDX-License-Identifier: GPL-3.0-or-later
"""Milliseconds from the end of a stroke to new colours and lines, part by part, and those of a window's drag:

    python3 tests/ui/window.py latency [VERTICES…]

Medians of strokes painted with the mouse. The parts are those that the add-on measures, from Blender's word that the
stroke is over ("wait") to "total"; "other" is mostly a thread's result waiting for Blender, which draws meanwhile.
"redraw" is how long Blender takes from there to have drawn all, here by software.
"""

from collections.abc import Callable
from statistics import median
from time import perf_counter

import bpy
import numpy as np
import screen
from canvas import add_sheet, ball, go_to, stroke
from dirichlet_isolines.blender import live
from steps import Waiting, run, until, words

_REPEATS = 5
_SIZES = [int(word) for word in words] or [14_000, 125_000, 1_000_000]

_drawn: list[dict[str, float]] = []  # parts of every update that was drawn, in seconds
_shown = [0]  # versions of the preview
_rows: list[tuple[str, list[dict[str, float]]]] = []


def measure() -> Waiting:
    bpy.types.SpaceView3D.draw_handler_add(_note_drawing, (), "WINDOW", "POST_PIXEL")
    for size in _SIZES:
        yield from add_sheet(size)
        _prepare()
        yield from until(lambda: _drawn and _is_quiet())
        vertices = f"{len(ball().data.vertices):,} vertices"
        yield from _repeat(f"stroke, {vertices}", _stroke, last=True)
        yield from _repeat(f"window, {vertices}", _slide)
        ball().dirichlet.live = False  # so that nobody looks whether the paint has changed, too
        yield from _repeat("the same without Live", _slide)


def print_table() -> Waiting:
    yield 0
    parts = list(dict.fromkeys(part for _, samples in _rows for part in samples[-1]))
    print(f"\n{'ms':28}", *(f"{part:>9}" for part in parts))
    for name, samples in _rows:
        middle = [1000 * median(sample.get(part, 0) for sample in samples) for part in parts]
        print(f"{name:28}", *(f"{value:9.1f}" for value in middle))


def _prepare() -> None:
    """Two patches painted, solved, and followed."""
    obj = ball()
    heights = np.array([vertex.co.x for vertex in obj.data.vertices])
    for name, vertices in (("left", heights < -0.9), ("right", heights > 0.9)):
        obj.vertex_groups.new(name=name).add(np.flatnonzero(vertices).tolist(), 1.0, "REPLACE")
        with screen.at():
            bpy.ops.dirichlet.patch_add_group(group=name)
    go_to("WEIGHT_PAINT")
    obj.dirichlet.live = obj.dirichlet.preview = True


def _stroke(k: int) -> Waiting:
    x = -0.7 + 0.1 * k
    yield from stroke((x, -0.5), (x, 0.5))


def _slide(k: int) -> Waiting:
    """One step of the mouse along the slider."""
    ball().dirichlet.window_low_place = 0.1 + 0.02 * k
    yield 0


def _repeat(name: str, change: Callable[[int], Waiting], last: bool = False) -> Waiting:
    """Takes the first update drawn after each change, or the last one, since Live may catch up under a brush."""
    samples = []
    for k in range(_REPEATS):
        yield 0.5
        before = len(_drawn)
        yield from change(k)
        yield from until(lambda: len(_drawn) > before and _is_quiet(), 120)  # noqa: B023
        samples.append(_drawn[-1 if last else before])
    _rows.append((name, samples))


def _note_drawing() -> None:
    preview = live.preview_of(ball())
    if preview and preview.version != _shown[-1]:
        _shown.append(preview.version)
        parts = live.timings(ball())
        updated = live._followers[ball().as_pointer()].noted + parts["total"]
        total = parts.pop("total")
        rest = {"other": total - sum(parts.values()), "total": total, "redraw": perf_counter() - updated}
        _drawn.append(parts | rest)


def _is_quiet() -> bool:
    return not live.is_pending(ball())


run(measure, print_table)
