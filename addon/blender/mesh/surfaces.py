# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh that an object's equations are made of."""

from __future__ import annotations

from typing import Any

import bpy

from . import evaluated
from .sessions import Session


def read(obj: bpy.types.Object, session: Session, depsgraph: bpy.types.Depsgraph | None = None) -> Any:
    """The library's Mesh: deformed where the object uses its modifiers and its Laplacian sees positions.

    session: the object's; depsgraph: that of a handler. Raises InputError where modifiers change the faces.
    """
    if not obj.dirichlet.use_modifiers:
        return session.mesh
    positions = evaluated.require_positions(obj, session.arrays, depsgraph)
    return session.mesh if obj.dirichlet.laplacian == "graph" else session.deformed(positions)
