# SPDX-License-Identifier: GPL-3.0-or-later
"""From a mesh object and its settings to a field and isolines on it.

Plain functions for operators, scripts and tests. They raise the library's DirichletError before they write anything.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from .. import library
from . import attributes, curves, groups, levels, material, meshes, ramp, results

Progress = Callable[[float], None]  # called with the part done, from 0 to 1


@dataclass(frozen=True)
class FieldResult:
    """What Solve Field computed and wrote."""

    field: Any  # the library's Field, in float64
    mesh: Any  # the library's Mesh
    painting: Any  # the library's Painting: vertices and values
    warnings: tuple[str, ...]
    seconds: dict[str, float]  # the report's stages, and "read", "paint" and "write" of Blender's data


@dataclass(frozen=True)
class IsolineResult:
    """What Make Isolines computed and wrote."""

    lines: Any  # the library's Isolines
    object: bpy.types.Object  # the curve object
    warnings: tuple[str, ...]
    seconds: dict[str, float]  # "read", "connectivity", "isolines", "write"


def solve_field(obj: bpy.types.Object, *, progress: Progress = lambda done: None) -> FieldResult:
    """Solves between the patches of `obj.dirichlet` and writes attributes, material and `obj.dirichlet.results`."""
    surface, clock = library.load(), Stopwatch()
    meshes.require_mesh(obj)
    attributes.require_names(obj)
    mesh = meshes.read_mesh(obj.data)
    clock.lap("read")
    progress(0.1)
    painting = read_painting(obj)
    clock.lap("paint")
    progress(0.3)
    field = surface.solve(mesh, painting.vertices, painting.values, method=obj.dirichlet.method)
    clock.lap("solve")
    progress(0.8)
    shown = _show(obj, field.values.astype(np.float32).astype(np.float64))
    clock.lap("write")
    seconds = clock.laps | field.report.seconds
    seconds["read"] -= mesh.build_seconds
    warnings = (*painting.warnings, *field.report.warnings, *shown)
    result = FieldResult(field, mesh, painting, warnings, seconds)
    results.record_field(obj.dirichlet.results, result)
    return result


def read_painting(obj: bpy.types.Object):
    """The library's Painting of the enabled patches. Raises InputError naming groups and vertices."""
    return library.load().combine_patches(read_patches(obj), len(obj.data.vertices), obj.dirichlet.overlap)


def read_patches(obj: bpy.types.Object) -> list[Any]:
    """The library's Patch of every enabled patch.

    A vertex belongs to a patch when its weight in the group is above 0 and at least the threshold, or just above 0
    when the patch takes its weights as values. Raises InputError naming groups and vertices.
    """
    surface, settings = library.load(), obj.dirichlet
    patches = [patch for patch in settings.patches if patch.enabled]
    missing = [patch.group for patch in patches if patch.group not in obj.vertex_groups]
    if missing:
        rest = f" (and {len(missing) - 1} more)" if len(missing) > 1 else ""
        raise surface.InputError(f"object '{obj.name}' has no vertex group '{missing[0]}'{rest}: pick one in the list")
    painted = []
    for patch, weights in zip(patches, groups.read_weights(obj.data, [patch.group for patch in patches])):
        if np.isnan(weights).any():
            vertex = int(np.flatnonzero(np.isnan(weights))[0])
            raise surface.InputError(f"vertex group '{patch.group}': the weight of vertex {vertex} is not a number")
        lowest = 0.0 if patch.weights_as_values else settings.threshold
        vertices = np.flatnonzero((weights > 0) & (weights >= np.float32(lowest)))
        values = weights[vertices].astype(np.float64) if patch.weights_as_values else patch.value
        painted.append(surface.Patch(patch.group, vertices, values))
    return painted


def make_isolines(obj: bpy.types.Object, *, progress: Progress = lambda done: None) -> IsolineResult:
    """Extracts isolines of the field that the mesh carries, and writes them into the object's curve object."""
    surface, clock = library.load(), Stopwatch()
    meshes.require_mesh(obj)
    values = attributes.read_field(obj.data)
    mesh = meshes.read_mesh(obj.data)
    clock.lap("read")
    progress(0.2)
    if np.isnan(values).all():
        raise surface.InputError(f"the field of mesh '{obj.data.name}' is undefined everywhere: run Solve Field again")
    chosen = levels.choose_levels(obj.dirichlet, float(np.nanmin(values)), float(np.nanmax(values)))
    lines = surface.isolines(mesh, values, chosen)
    clock.lap("extract")
    progress(0.4)
    curve = curves.write(obj, lines, ramp.colors(obj, lines.levels, ramp.limits(values)))
    clock.lap("write")
    seconds = {
        "read": clock.laps["read"] - mesh.build_seconds,
        "connectivity": mesh.build_seconds,
        "isolines": lines.seconds,
        "write": clock.laps["write"],
    }
    result = IsolineResult(lines, curve, tuple(lines.warnings), seconds)
    results.record_isolines(obj.dirichlet.results, result)
    return result


def update_colors(obj: bpy.types.Object) -> None:
    """Writes `dirichlet_color` anew from the field that the mesh carries and the ramp as it is now."""
    meshes.require_mesh(obj)
    attributes.require_names(obj)
    values = attributes.read_field(obj.data)
    attributes.write_colors(obj.data, ramp.colors(obj, values, ramp.limits(values)))


def apply_preset(obj: bpy.types.Object) -> None:
    """Puts the chosen preset's stops into the ramp of the object's field material, and the colours through it.

    In Edit Mode the mesh cannot be written, so its colours wait for Update Colors.
    """
    node = material.find_ramp(obj)
    if not node:
        return
    recolored = not obj.data.is_editmode and attributes.has_field(obj.data)
    if recolored:
        attributes.require_names(obj)
    material.set_stops(node.color_ramp, library.load("ramps").RAMPS[obj.dirichlet.ramp_preset])
    if recolored:
        update_colors(obj)


def _show(obj: bpy.types.Object, values: NDArray[np.float64]) -> list[str]:
    """Material, then attributes, since the colours go through the material's ramp. Returns warnings."""
    ramps = library.load("ramps")
    ends = ramp.limits(values)
    warnings = material.show(obj, ends, ramps.RAMPS[obj.dirichlet.ramp_preset], ramps.UNDEFINED_COLOR)
    attributes.write(obj.data, values, ramp.colors(obj, values, ends))
    return warnings


class Stopwatch:
    """Seconds of successive stages."""

    def __init__(self) -> None:
        self.laps: dict[str, float] = {}
        self._last = perf_counter()

    def lap(self, name: str) -> None:
        now = perf_counter()
        self.laps[name] = now - self._last
        self._last = now
