# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that isolines were written into, and how they belong to the mesh object they were made of.

A mesh object points at the one result bound to it, so both may be renamed: Make Isolines updates that one, by the mesh
object's settings. A result whose parent was cleared, or that was duplicated, is bound no more: it is the user's, and
its own settings, remembered when it was last made, are what it is refreshed by. One whose mesh object was deleted is
disowned: it keeps them for another mesh object to come.
"""

from __future__ import annotations

import bpy

from ... import library
from ...language import say
from .. import settings as line_settings

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
    return obj.type in TYPES and obj.dirichlet_isolines.is_property_set("source")  # it may be empty by now


def find_source(result: bpy.types.Object) -> bpy.types.Object | None:
    """The mesh object of a result, unless the user deleted it: Blender keeps it as long as something points at it."""
    source = result.dirichlet_isolines.source
    return source if source and source.users_collection else None


def settings_of(result: bpy.types.Object | None, source: bpy.types.Object | None) -> bpy.types.PropertyGroup:
    """What the result is made by: the mesh object's settings while it is bound to it or new, else its own."""
    return source.dirichlet if source and result in (None, find(source)) else result.dirichlet_isolines


def drawn_by(settings: bpy.types.PropertyGroup) -> bpy.types.Object | None:
    """The mesh object whose lines change with a mesh object's or a result's settings."""
    owner = settings.id_data
    if settings != owner.dirichlet_isolines:
        return owner
    return None if settings.source is None or find(settings.source) == owner else settings.source


def require_source(result: bpy.types.Object) -> bpy.types.Object:
    """The mesh object of a result that may be changed. Raises the library's InputError."""
    source = find_source(result)
    if source is None:
        raise library.load().InputError(say("object '{name}' has no mesh object that it was made of", name=result.name))
    if result.dirichlet_isolines.locked:
        raise library.load().InputError(say("object '{name}' is locked: switch off Lock first", name=result.name))
    return source


def followers(source: bpy.types.Object) -> list[bpy.types.Object]:
    """Results of a mesh object that are to change with it: those with Follow, and the bound one while Live is on; none
    that the user deleted, which Blender keeps as long as something points at it."""
    bound = find_unlocked(source)
    found = [bound] if bound and (source.dirichlet.live or bound.dirichlet_isolines.follow) else []
    if source.dirichlet.followed:
        found += [obj for obj in bpy.data.objects if obj != bound and _follows(obj, source)]
    return [obj for obj in found if obj.users_collection]


def _follows(obj: bpy.types.Object, source: bpy.types.Object) -> bool:
    note = obj.dirichlet_isolines
    return note.follow and note.source == source and not note.locked and obj.type in TYPES


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


def remember(result: bpy.types.Object, source: bpy.types.Object) -> None:
    """Notes what the result was made of and by."""
    note = result.dirichlet_isolines
    if note.source != source:
        note.source = source
    line_settings.copy(settings_of(result, source), note)


def replace(result: bpy.types.Object, data: bpy.types.ID) -> bpy.types.Object:
    """An object with data of another type in the place of the result: name, parent, children, collections, transform,
    visibility, selection and settings. Modifiers and constraints stay behind. The result is gone afterwards, and its
    settings with it: `settings_of` has the new ones."""
    made, name, note = bpy.data.objects.new(data.name, data), result.name, result.dirichlet_isolines
    made.dirichlet_isolines.source = note.source
    line_settings.copy(note, made.dirichlet_isolines)
    if find(note.source) == result:
        note.source.dirichlet.isolines = made
    made.parent, made.matrix_parent_inverse = result.parent, result.matrix_parent_inverse
    made.matrix_basis = result.matrix_basis
    made.hide_viewport, made.hide_render = result.hide_viewport, result.hide_render
    for collection in result.users_collection:
        collection.objects.link(made)
    for child in result.children:
        child.parent, child.matrix_parent_inverse = made, child.matrix_parent_inverse.copy()
    _take_selection(result, made)
    remove(result)
    made.name = name
    return made


def _take_selection(old: bpy.types.Object, new: bpy.types.Object) -> None:
    """Both are in the same collections."""
    objects = bpy.context.view_layer.objects
    if old.name in objects:
        new.select_set(old.select_get())
        if objects.active == old:
            objects.active = new


def remove(result: bpy.types.Object) -> None:
    """Removes the result, and its data and materials made for it where nothing else uses them."""
    from .outputs import materials

    data = result.data
    bpy.data.objects.remove(result)
    if not data.users:
        spare = list(data.materials)
        bpy.data.batch_remove([data])
        materials.remove_spare(spare)
