# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that are remembered while Blender goes on, and whether they are still what they were."""

from __future__ import annotations

import bpy

from .. import library
from ..language import say
from .mesh import meshes


class Held:
    """An object between two looks at it, in which it may be renamed, edited, undone or removed."""

    def __init__(self, obj: bpy.types.Object) -> None:
        self.name = obj.name  # when last seen
        self._address, self._type = obj.as_pointer(), obj.type
        self._arrays: meshes.Arrays | None = None

    def now(self) -> bpy.types.Object | None:
        """The object there now, whatever its name; the last name is tried first."""
        obj = bpy.data.objects.get((self.name, None))
        if obj is None or obj.as_pointer() != self._address:
            obj = next((obj for obj in bpy.data.objects if obj.as_pointer() == self._address), None)
        if obj is None or obj.type != self._type:  # deleted, and its address given to another
            return None
        self.name = obj.name
        return obj

    def keep(self, arrays: meshes.Arrays | None) -> None:
        """These are the arrays that results will be for; nothing: they are for any."""
        self._arrays = arrays

    def fits(self, obj: bpy.types.Object) -> bool:
        """Whether the object can be read and is what `keep` was told: another may be in its place."""
        return obj.mode != "EDIT" and (self._arrays is None or self._arrays.same(meshes.read_arrays(obj.data)))

    def find(self) -> bpy.types.Object:
        """The object now. Raises InputError when it is gone."""
        obj = self.now() or bpy.data.objects.get((self.name, None))  # which undo may have put elsewhere
        if obj is None:
            raise library.load().InputError(
                say("object '{name}' was removed while it was being worked on", name=self.name)
            )
        return obj

    def find_mesh(self) -> bpy.types.Object:
        """The mesh object now. Raises InputError when it is gone, cannot be read now or is not what `keep` was told."""
        obj = self.find()
        meshes.require_mesh(obj)
        if not self.fits(obj):
            raise library.load().InputError(
                say("the mesh of object '{name}' changed while it was being worked on", name=self.name)
            )
        return obj
