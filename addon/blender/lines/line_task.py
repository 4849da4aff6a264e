# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines in three steps: read the object, compute (in any thread, without Blender's data), write."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import counted, say
from ...sentences import told
from .. import results
from ..look import ramp
from ..mesh import attributes, evaluated, meshes
from ..mesh.sessions import Session, open_session
from ..stopwatch import Stopwatch
from . import levels, result_drawing, result_objects, shaping


@dataclass(frozen=True)
class LineTask:
    """All that the isolines of an object depend on, but the field's values."""

    mesh: Any  # the library's Mesh
    options: levels.LevelOptions
    shape: shaping.ShapeOptions
    positions: NDArray[np.float64] | None  # (V, 3) that the lines are moved to; nothing where they need not
    table: ramp.ColorTable
    clock: Stopwatch
    warnings: tuple[str, ...] = ()
    cancel: Any = field(default_factory=lambda: library.load().CancelToken())

    def interrupt(self) -> None:
        """Ends `compute` by the library's CancelledError, also before it has begun."""
        self.cancel.cancel()

    def compute(self, values: NDArray[np.float32], most_levels: int | None = None) -> LineOutcome:
        """values: (V,) as the mesh stores them, not all of them NaN. Raises the library's InputError, also for more
        levels than wanted."""
        self.clock.restart()
        ends = ramp.limits(values)
        surface = library.load()
        chosen = self.options.choose_on(self.mesh, values, self.cancel)
        if most_levels is not None and len(chosen) > most_levels:
            raise surface.InputError(
                say("{count} levels are too many to follow: Make Isolines draws them", count=len(chosen))
            )
        lines = surface.isolines(self.mesh, values, chosen, cancel=self.cancel)
        lines = self.shape.on_surface(self.mesh, lines, self.cancel)
        if self.positions is not None:
            lines = surface.move_lines(lines, self.positions)
        lines = self.shape.in_space(lines, self.cancel)
        self.clock.lap("isolines")
        window = self.options.window_in(float(np.fmin.reduce(values)), float(np.fmax.reduce(values)))
        factors = self.shape.factors(lines.levels, window)
        return LineOutcome(self, lines, self.table.apply(lines.levels, ends), factors)


@dataclass(frozen=True)
class LineOutcome:
    """Isolines that are computed but not written."""

    task: LineTask
    lines: Any  # the library's Isolines, in object space
    colors: NDArray[np.float32]  # (K, 4) linear, one per level
    factors: NDArray[np.float32]  # (K,) of the thickness, one per level


@dataclass(frozen=True)
class IsolineResult:
    """What was computed and written."""

    lines: Any  # the library's Isolines
    object: bpy.types.Object  # the result they were written into
    warnings: tuple[str, ...]
    seconds: dict[str, float]  # "read", "connectivity", "isolines", "write"

    @property
    def summary(self) -> str:
        """One line for people."""
        lines = self.lines
        return say(
            "{lines} at {levels}, {closed} closed",
            lines=counted(len(lines), "1 isoline", "{count} isolines"),
            levels=counted(len(lines.levels), "1 level", "{count} levels"),
            closed=int(lines.closed.sum()),
        )


def read(
    obj: bpy.types.Object,
    result: bpy.types.Object | None,
    *,
    session: Session | None = None,
    depsgraph: bpy.types.Depsgraph | None = None,
) -> LineTask:
    """By what the result is made by, or by the object's settings for a new one. session: the object's, if it is open;
    depsgraph: that of a handler. Raises the library's InputError and TopologyError, naming what is wrong with
    the object."""
    clock = Stopwatch()
    meshes.require_mesh(obj)
    session = session or open_session(obj)
    settings = result_objects.settings_of(result, obj)
    positions = _read_positions(obj, session, depsgraph)
    task = LineTask(
        session.mesh,
        levels.read_options(settings),
        shaping.read_options(settings, session.arrays.diagonal),
        positions,
        ramp.read_table(obj),
        clock,
        (_beside_surface(obj, depsgraph),) if _is_deformed(obj) and positions is None else (),
    )
    clock.lap("read")
    return task


def read_values(obj: bpy.types.Object) -> NDArray[np.float32]:
    """(V,) of the field that the mesh carries. Raises InputError when there is none, or none of it is defined."""
    values = attributes.read_field(obj.data)
    if np.isnan(values).all():
        raise library.load().InputError(
            say("the field of mesh '{mesh}' is undefined everywhere: run Solve Field again", mesh=obj.data.name)
        )
    return values


def _read_positions(obj, session: Session, depsgraph) -> NDArray[np.float64] | None:
    """Where the vertices are shown, unless it is where they are or modifiers change the faces."""
    if obj.dirichlet.use_modifiers:
        return evaluated.require_positions(obj, session.arrays, depsgraph)
    return evaluated.read_positions(obj, session.arrays, depsgraph) if _is_deformed(obj) else None


def _is_deformed(obj: bpy.types.Object) -> bool:
    return bool(obj.modifiers or obj.data.shape_keys)


def _beside_surface(obj: bpy.types.Object, depsgraph) -> str:
    if not evaluated.is_evaluated(obj, depsgraph):
        return say(
            "object '{object}' is disabled in viewports or not in this view layer: the lines lie on the mesh without "
            "its modifiers",
            object=obj.name,
        )
    return say(
        "modifiers of object '{object}' change its faces: the lines lie on the mesh without them, so apply them, such "
        "as Subdivision Surface, before painting",
        object=obj.name,
    )


def _no_lines() -> str:
    return say("there are no isolines: no level lies between values that meet, or all lines are below Shortest")


def write(
    obj: bpy.types.Object, outcome: LineOutcome, result: bpy.types.Object | None, doubts: tuple[str, ...] = ()
) -> IsolineResult:
    """Puts the lines into the result, or into a new one bound to the object. Records `obj.dirichlet.results` when it is
    the bound one. doubts: about the field, to be told first."""
    task, lines = outcome.task, outcome.lines
    task.clock.restart()
    drawn = result_drawing.write(obj, result, lines, outcome.colors, outcome.factors)
    task.clock.lap("write")
    seconds = task.clock.laps | {"connectivity": task.mesh.build_seconds}
    warnings = (*doubts, *task.warnings, *map(told, lines.warnings), *(() if len(lines) else (_no_lines(),)))
    made = IsolineResult(lines, drawn, warnings, seconds)
    if result_objects.find(obj) == drawn:
        results.record_isolines(obj.dirichlet.results, made)
    return made
