# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the field that a mesh carries is that of its patches as they are now."""

from __future__ import annotations

from typing import Any
from zlib import crc32

import bpy

from .. import library
from ..language import say
from .paint import painting


def fingerprint(obj: bpy.types.Object, painted: Any) -> str:
    """Another one whenever another field is to be expected. painted: the library's Painting of the object."""
    sizes = len(obj.data.vertices), len(obj.data.polygons)
    return " ".join(map(str, (*sizes, crc32(painted.vertices), crc32(painted.values))))


def doubt(obj: bpy.types.Object) -> str:
    """A sentence when the field last solved for is not that of the patches; else nothing. Costs reading their
    weights."""
    solved_for = obj.dirichlet.results.fingerprint
    if not solved_for:  # by another object on the same mesh
        return ""
    try:
        if fingerprint(obj, painting.read_painting(obj)) == solved_for:
            return ""
        reason = say("run Solve Field")
    except library.load().DirichletError as error:
        reason = str(error)
    return say("the field of '{object}' is older than its patches: {reason}", object=obj.name, reason=reason)
