# SPDX-License-Identifier: GPL-3.0-or-later
"""What is painted on an object, as the library's patches."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say
from ..mesh import evaluated, groups


def read_painting(obj: bpy.types.Object) -> Any:
    """The library's Painting of the enabled patches. Raises InputError naming groups and vertices."""
    return combine(obj, read_patches(obj))


def combine(obj: bpy.types.Object, patches: list[Any]) -> Any:
    """The library's Painting of what `read_patches` returned. Raises InputError naming groups and vertices."""
    return library.load().combine_patches(patches, len(obj.data.vertices), obj.dirichlet.overlap)


def read_patches(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph | None = None) -> list[Any]:
    """The library's Patch of every enabled patch; depsgraph: that of a handler.

    A vertex belongs to a patch when its weight in the group is above 0 and at least the threshold, or just above 0
    when the patch takes its weights as values. Raises InputError naming groups and vertices.
    """
    surface, settings = library.load(), obj.dirichlet
    patches = [patch for patch in settings.patches if patch.enabled]
    names = set(obj.vertex_groups.keys())
    missing = [patch.group for patch in patches if patch.group not in names]
    if missing:
        raise surface.InputError(
            say(
                "object '{object}' has no vertex group '{group}'{rest}: pick one in the list",
                object=obj.name,
                group=missing[0],
                rest=_and_more(len(missing)),
            )
        )
    with evaluated.mesh_to_read(obj, depsgraph) as mesh:
        weights = groups.read_weights(mesh, [patch.group for patch in patches])
        return [_read_patch(patch, found, settings.threshold) for found, patch in zip(weights, patches, strict=True)]


def _and_more(count: int) -> str:
    """After the first of so many."""
    return " " + say("(and {count} more)", count=count - 1) if count > 1 else ""


def _read_patch(patch: bpy.types.PropertyGroup, weights: NDArray[np.float32], threshold: float) -> Any:
    surface = library.load()
    if np.isnan(weights).any():
        vertices = np.flatnonzero(np.isnan(weights))
        raise surface.InputError(
            say(
                "vertex group '{group}': the weight of vertex {vertex}{rest} is not a number",
                group=patch.group,
                vertex=vertices[0],
                rest=_and_more(len(vertices)),
            )
        )
    lowest = 0.0 if patch.weights_as_values else threshold
    vertices = np.flatnonzero((weights > 0) & (weights >= np.float32(lowest)))
    values = weights[vertices].astype(np.float64) if patch.weights_as_values else patch.value
    return surface.Patch(patch.group, vertices, values)
