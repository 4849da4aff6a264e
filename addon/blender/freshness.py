# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the field that a mesh carries is that of its patches as they are now, and of its shape where that counts."""

from __future__ import annotations

from typing import Any
from zlib import crc32

import bpy

from .. import library
from ..language import say
from ..sentences import told
from .mesh import sessions, surfaces
from .paint import painting


def fingerprint(laplacian: str, surface: Any, painted: Any) -> str:
    """Another one whenever another field is to be expected. surface: the library's Mesh solved on; painted: its
    Painting."""
    seen = () if laplacian == "graph" else (crc32(surface.positions),)
    sizes = surface.vertex_count, surface.face_count
    return " ".join(map(str, (laplacian, *sizes, crc32(painted.vertices), crc32(painted.values), *seen)))


def tell_others(obj: bpy.types.Object) -> None:
    """The field just written is also that of the objects that share the mesh, whatever they solved for."""
    solved_for = obj.dirichlet.results.fingerprint
    if obj.data.users > 1:
        for other in bpy.data.objects:
            if other.data == obj.data and other.dirichlet.results.fingerprint not in ("", solved_for):
                other.dirichlet.results.fingerprint = solved_for


def doubt(obj: bpy.types.Object) -> str:
    """A sentence when the field last solved for is not that of the patches and the shape; else nothing. Costs reading
    them."""
    solved_for = obj.dirichlet.results.fingerprint
    if not solved_for:  # it never was: another object on the same mesh was
        return ""
    try:
        surface = surfaces.read(obj, sessions.open_session(obj))
        if fingerprint(obj.dirichlet.laplacian, surface, painting.read_painting(obj)) == solved_for:
            return ""
        reason = say("run Solve Field")
    except library.load().DirichletError as error:
        reason = told(error)
    return say(
        "the field of '{object}' is older than its patches, shape or Laplacian: {reason}",
        object=obj.name,
        reason=reason,
    )
