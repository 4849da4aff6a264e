# SPDX-License-Identifier: GPL-3.0-or-later
"""A field in three steps: read the object, compute (in any thread, without Blender's data), write."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from .. import library
from ..sentences import told
from . import expected_memory, freshness, preferences, results
from .look import looks, material, ramp
from .mesh import attributes, meshes, surfaces
from .mesh.sessions import Session, make_room, open_session
from .paint import painting
from .stopwatch import Stopwatch


@dataclass(frozen=True)
class FieldTask:
    """All that the field of an object depends on."""

    session: Session
    surface: Any  # the library's Mesh whose positions count, where the Laplacian sees any
    patches: list[Any]  # the library's Patch of every enabled patch
    painting: Any  # the library's Painting: vertices and values
    options: dict[str, Any]  # of the library's HarmonicSolver
    table: ramp.ColorTable | None  # nothing before there is a ramp: `write` makes one
    clock: Stopwatch
    cancel: Any = field(default_factory=lambda: library.load().CancelToken())

    def interrupt(self) -> None:
        """Ends `compute` by the library's CancelledError, also before it has begun."""
        self.session.interrupt(self.cancel)

    def fingerprint(self) -> str:
        return freshness.fingerprint(self.options["laplacian"], self.surface, self.painting)

    def compute(self) -> FieldOutcome:
        """Raises what HarmonicSolver and its `paint` raise."""
        self.clock.restart()
        values, report = self.session.paint(self.painting, self.options, self.surface, self.cancel)
        self.clock.lap("solve")
        shown = values.astype(np.float32)
        ends = ramp.limits(shown)
        colors = self.table.apply(shown, ends) if self.table else None
        self.clock.lap("colors")
        return FieldOutcome(self, library.load().Field(values, report), shown, ends, colors)


@dataclass(frozen=True)
class FieldOutcome:
    """A field that is computed but not written."""

    task: FieldTask
    field: Any  # the library's Field, in float64
    values: NDArray[np.float32]  # (V,) as the mesh stores them
    ends: tuple[float, float]  # values at the ends of the ramp
    colors: NDArray[np.float32] | None  # (V, 4)


@dataclass(frozen=True)
class FieldResult:
    """What was computed and written."""

    field: Any
    mesh: Any  # the library's Mesh
    painting: Any
    warnings: tuple[str, ...]
    seconds: dict[str, float]  # the report's stages, and "read", "paint", "colors", "write" of Blender's data
    fingerprint: str  # see freshness.py


def read(
    obj: bpy.types.Object, *, session: Session | None = None, depsgraph: bpy.types.Depsgraph | None = None
) -> FieldTask:
    """session: the object's, if it is open; depsgraph: that of a handler. Raises the library's InputError and
    TopologyError, naming what is wrong with the object."""
    clock = Stopwatch()
    meshes.require_mesh(obj)
    attributes.require_names(obj)
    session = session or open_session(obj)
    surface = surfaces.read(obj, session, depsgraph)
    clock.lap("read")
    patches = painting.read_patches(obj, depsgraph)
    painted = painting.combine(obj, patches)
    clock.lap("paint")
    table = ramp.read_table(obj) if material.find_ramp(obj) else None
    clock.lap("read")
    options = _options(obj.dirichlet)
    make_room(session, expected_memory.of_object(obj, options["memory_budget"]))
    return FieldTask(session, surface, patches, painted, options, table, clock)


def _options(settings: bpy.types.PropertyGroup) -> dict[str, Any]:
    return {
        "laplacian": settings.laplacian,
        "method": settings.method,
        "memory_budget": preferences.memory_budget(),
    }


def write(obj: bpy.types.Object, outcome: FieldOutcome, *, cover: bool = True) -> FieldResult:
    """Material, attributes and `obj.dirichlet.results`; only what differs from what is there. Without `cover` the
    material is not put where the user has put another."""
    task, ramps, shown = outcome.task, library.load("ramps"), []
    task.clock.restart()
    if cover or not attributes.has_field(obj.data):
        begun = material.find_ramp(obj) is None
        shown = material.show(obj, outcome.ends, ramps.RAMPS[obj.dirichlet.ramp_preset], ramps.UNDEFINED_COLOR)
        if begun:
            looks.apply(obj)
    else:
        material.update_range(obj, outcome.ends)
    colors = ramp.read_table(obj).apply(outcome.values, outcome.ends) if outcome.colors is None else outcome.colors
    attributes.write(obj.data, outcome.values, colors)
    task.clock.lap("write")
    field = outcome.field
    warnings = (*map(told, (*task.painting.warnings, *field.report.warnings)), *shown)
    seconds = task.clock.laps | field.report.seconds
    result = FieldResult(field, task.session.mesh, task.painting, warnings, seconds, task.fingerprint())
    results.record_field(obj.dirichlet.results, result)
    freshness.tell_others(obj)
    return result
