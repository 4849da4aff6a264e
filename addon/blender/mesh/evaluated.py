# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh objects as modifiers, shape keys and armatures leave them, and at frames that are rendered."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say
from .. import settings
from . import meshes


def read_positions(
    obj: bpy.types.Object, arrays: meshes.Arrays, depsgraph: bpy.types.Depsgraph | None = None
) -> NDArray[np.float64] | None:
    """(V, 3) in object space; nothing where modifiers change the faces, or Blender does not evaluate them.

    arrays: of the object's own mesh; depsgraph: that of a handler, else the context's.
    """
    if not is_evaluated(obj, depsgraph):
        return None
    found = meshes.read_arrays(_evaluate(obj, depsgraph).data)
    return found.positions.astype(np.float64) if found.same_faces(arrays) else None


def require_positions(
    obj: bpy.types.Object, arrays: meshes.Arrays, depsgraph: bpy.types.Depsgraph | None = None
) -> NDArray[np.float64]:
    """As `read_positions`, but raises InputError in place of nothing."""
    if not is_evaluated(obj, depsgraph):
        raise library.load().InputError(
            say(
                "object '{object}' is disabled in viewports or not in this view layer, so its modifiers do nothing: "
                "enable it there, or switch off Use Modifiers",
                object=obj.name,
            )
        )
    positions = read_positions(obj, arrays, depsgraph)
    if positions is None:
        changed = _evaluate(obj, depsgraph).data
        raise library.load().InputError(
            say(
                "the modifiers of object '{object}' make {vertices} vertices and {faces} faces of the "
                "{painted_vertices} vertices and {painted_faces} faces that are painted: switch off Use "
                "Modifiers, or these modifiers",
                object=obj.name,
                vertices=len(changed.vertices),
                faces=len(changed.polygons),
                painted_vertices=len(arrays.positions),
                painted_faces=len(arrays.offsets) - 1,
            )
        )
    return positions


def is_evaluated(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph | None = None) -> bool:
    """Whether the object is anywhere where Blender gives it a shape; hidden by the eye, it still has one."""
    return bool(_evaluate(obj, depsgraph).is_evaluated)


@contextmanager
def mesh_to_read(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph | None = None) -> Iterator[bpy.types.Mesh]:
    """The mesh whose weights count: that of the modifiers, for the time being, if the object uses them."""
    if not obj.dirichlet.use_modifiers:
        yield obj.data
        return
    depsgraph = depsgraph or bpy.context.evaluated_depsgraph_get()
    mesh = bpy.data.meshes.new_from_object(
        obj.evaluated_get(depsgraph), preserve_all_data_layers=True, depsgraph=depsgraph
    )
    try:
        yield mesh
    finally:
        bpy.data.meshes.remove(mesh)


def take_values(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph) -> None:
    """Gives the settings what animation and drivers make of them at the frame: a render animates copies of its own, and
    leaves the originals as they were."""
    animated = obj.evaluated_get(depsgraph)
    if not obj.animation_data or animated == obj:
        return
    settings.copy(animated.dirichlet, obj.dirichlet)
    settings.copy(animated.dirichlet_isolines, obj.dirichlet_isolines)
    for theirs, ours in zip(animated.dirichlet.patches, obj.dirichlet.patches):
        settings.copy(theirs, ours)


def _evaluate(obj: bpy.types.Object, depsgraph: bpy.types.Depsgraph | None) -> bpy.types.Object:
    return obj.evaluated_get(depsgraph or bpy.context.evaluated_depsgraph_get())
