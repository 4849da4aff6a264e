# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that isolines were written into, and how they belong to the mesh object they were made of.

A mesh object points at the one result bound to it, so both may be renamed: Make Isolines updates that one, by the mesh
object's settings. A result whose parent was cleared, or that was duplicated, is bound no more: it is the user's, and
its own settings, remembered when it was last made, are what it is refreshed by.
"""

from __future__ import annotations

from collections.abc import Iterator

import bpy

from .. import library
from . import settings as line_settings

TYPES = ("CURVE", "MESH", "CURVES")


def find(obj: bpy.types.Object) -> bpy.types.Object | None:
    """The result bound to a mesh object, if it has one."""
    found = obj.dirichlet.isolines
    return found if found and found.parent == obj and found.type in TYPES else None


def find_unlocked(obj: bpy.types.Object) -> bpy.types.Object | None:
    """The result bound to a mesh object, if there is one that may be changed."""
    found = find(obj)
    return found if found and not found.dirichlet_isolines.locked else None


def is_result(obj: bpy.types.Object) -> bool:
    return obj.type in TYPES and obj.dirichlet_isolines.source is not None


def settings_of(result: bpy.types.Object, source: bpy.types.Object) -> bpy.types.PropertyGroup:
    """What the result is made by: the mesh object's settings while it is bound to it, else its own."""
    return source.dirichlet if find(source) == result else result.dirichlet_isolines


def require_source(result: bpy.types.Object) -> bpy.types.Object:
    """The mesh object of a result that may be changed. Raises the library's InputError."""
    note = result.dirichlet_isolines
    if note.source is None:
        raise library.load().InputError(f"object '{result.name}' has no mesh object that it was made of")
    if note.locked:
        raise library.load().InputError(f"object '{result.name}' is locked: switch off Lock first")
    return note.source


def results_of(source: bpy.types.Object) -> Iterator[bpy.types.Object]:
    """Every result made of a mesh object, bound or not."""
    return (obj for obj in bpy.data.objects if is_result(obj) and obj.dirichlet_isolines.source == source)


def add(source: bpy.types.Object, data: bpy.types.ID) -> bpy.types.Object:
    """A result with this data, bound to the mesh object and in its place and collections."""
    result = bpy.data.objects.new(data.name, data)
    result.parent = source
    source.dirichlet.isolines = result
    link(result, source)
    return result


def link(result: bpy.types.Object, source: bpy.types.Object) -> None:
    """Puts a result that is in no collection into those of the mesh object."""
    if not result.users_collection:  # made, or deleted by the user but still pointed at
        for collection in source.users_collection:
            collection.objects.link(result)


def remember(result: bpy.types.Object, source: bpy.types.Object, settings: bpy.types.PropertyGroup) -> None:
    """Notes what the result was made of and by."""
    note = result.dirichlet_isolines
    if note.source != source:
        note.source = source
    line_settings.copy(settings, note)


def replace(result: bpy.types.Object, data: bpy.types.ID) -> bpy.types.Object:
    """An object with data of another type in the place of the result: name, parent, children, collections, transform,
    selection and whatever pointed at it. Modifiers and constraints stay behind. The result is gone afterwards."""
    made, name = bpy.data.objects.new(data.name, data), result.name
    note = result.dirichlet_isolines
    made.dirichlet_isolines.source, made.dirichlet_isolines.follow = note.source, note.follow
    made.parent, made.matrix_parent_inverse = result.parent, result.matrix_parent_inverse
    made.matrix_basis = result.matrix_basis
    made.hide_viewport, made.hide_render = result.hide_viewport, result.hide_render
    result.user_remap(made)
    remove(result)
    made.name = name
    return made


def remove(result: bpy.types.Object) -> None:
    """Removes the result, and its data and materials made for it where nothing else uses them."""
    from .outputs import materials

    data = result.data
    bpy.data.objects.remove(result)
    if not data.users:
        spare = list(data.materials)
        bpy.data.batch_remove([data])
        materials.remove_spare(spare)
