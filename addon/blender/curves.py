# SPDX-License-Identifier: GPL-3.0-or-later
"""Isolines as a curve object: one poly spline per line, coloured by level, parented to the mesh object.

The mesh object points at its curve object, so both may be renamed. A curve that was duplicated with the mesh, or whose
parent was cleared, belongs to the user: the next run makes another.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import bpy
import numpy as np
from numpy.typing import NDArray

from . import material, meshes
from .names import CLOSED, LENGTH, LEVEL

_MOST_MATERIALS = 64  # more levels than that share them, neighbour with neighbour
_TAG = "dirichlet_isoline"  # on the materials made here; others in their slots are the user's and stay


class Splines(NamedTuple):
    """Lines as a curve stores them, in float32."""

    points: NDArray[np.float32]  # (P, 4): x, y, z and a weight of 1
    offsets: list[int]  # (L + 1,)
    closed: NDArray[np.bool_]  # (L,)
    level: NDArray[np.int32]  # (L,)
    length: NDArray[np.float64]  # (L,)


def find(obj: bpy.types.Object) -> bpy.types.Object | None:
    """The object's isolines, if it has them."""
    found = obj.dirichlet.isolines
    return found if found and found.parent == obj and found.type == "CURVE" else None


def write(obj: bpy.types.Object, lines, colors: NDArray[np.float32]) -> bpy.types.Object:
    """Puts the lines into the object's curve object, made if there is none.

    lines: the library's Isolines of the object's mesh; colors: (K, 4) linear, one per level.
    """
    target = find(obj) or _new_object(obj)
    if not target.users_collection:  # made, or deleted by the user but still pointed at
        for collection in obj.users_collection:
            collection.objects.link(target)
    curve = target.data
    count = min(len(colors), _MOST_MATERIALS)
    material_of_level = np.arange(len(colors)) * count // max(len(colors), 1)
    shown = [colors[material_of_level == k].mean(axis=0) for k in range(count)]
    _set_materials(curve, obj.name, np.array(shown))
    splines = split(lines)
    _set_splines(curve, splines, material_of_level[splines.level])
    curve[LEVEL] = lines.levels[splines.level].tolist()
    curve[CLOSED] = splines.closed.astype(int).tolist()
    curve[LENGTH] = splines.length.tolist()
    return target


def set_radius(obj: bpy.types.Object, fraction: float) -> None:
    """Sets the tubes' radius, as a fraction of the diagonal of the mesh, if the object has isolines."""
    target = find(obj)
    if target:
        target.data.bevel_depth = fraction * meshes.diagonal(obj.data)


def split(lines) -> Splines:
    """The lines without the points that coincide in succession, and without the lines that shrink to a point, once
    coordinates are rounded to Blender's float32."""
    points = np.ones((len(lines.points), 4), np.float32)
    points[:, :3] = lines.points
    starts, ends, closed = lines.offsets[:-1], lines.offsets[1:], lines.closed.astype(bool)
    previous = np.arange(len(points)) - 1
    previous[starts] = ends - 1
    kept = (points != points[previous]).any(axis=1)
    kept[starts[~closed]] = True
    sizes = np.add.reduceat(kept, starts, dtype=np.int64) if len(starts) else np.zeros(0, np.int64)
    whole = sizes > 1
    points = points[kept & np.repeat(whole, ends - starts)]
    offsets = [0, *np.cumsum(sizes[whole]).tolist()]
    return Splines(points, offsets, closed[whole], lines.level[whole], lines.length[whole])


def _new_object(obj: bpy.types.Object) -> bpy.types.Object:
    name = f"{obj.name}_isolines"
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_resolution = 2
    curve.use_fill_caps = True
    target = bpy.data.objects.new(name, curve)
    target.parent = obj
    obj.dirichlet.isolines = target
    set_radius(obj, obj.dirichlet.bevel_depth)
    return target


def _set_splines(curve: bpy.types.Curve, splines: Splines, materials: NDArray[np.intp]) -> None:
    curve.splines.clear()
    rows = zip(pairwise(splines.offsets), splines.closed.tolist(), materials.tolist())
    for (start, end), closed, slot in rows:
        spline = curve.splines.new("POLY")
        spline.points.add(end - start - 1)
        spline.points.foreach_set("co", splines.points[start:end].ravel())
        spline.use_cyclic_u = closed
        spline.material_index = slot


def _set_materials(curve: bpy.types.Curve, name: str, colors: NDArray[np.float32]) -> None:
    """One slot per colour: materials made here are recoloured, those the user put there instead stay."""
    slots = curve.materials
    for k, color in enumerate(colors.tolist()):
        if k == len(slots):
            slots.append(None)
        if slots[k] is None:
            slots[k] = material.new_with_nodes(f"{name} isoline {k + 1}")[0]
            slots[k][_TAG] = True
        if _TAG in slots[k]:
            _recolor(slots[k], color)
    while len(slots) > len(colors) and (slots[-1] is None or _TAG in slots[-1]):
        spare = slots.pop()
        if spare and not spare.users:
            bpy.data.materials.remove(spare)


def _recolor(line_material: bpy.types.Material, color: list[float]) -> None:
    line_material.diffuse_color = color
    for node in line_material.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = color
