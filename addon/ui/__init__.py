# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties, operators, lists and panels. No maths and no loops over vertices."""

import bpy

from . import (
    field_operators,
    lists,
    panels,
    patch_list_operators,
    patch_operators,
    patch_source_operators,
    preferences,
    properties,
)

_CLASSES = (
    *preferences.CLASSES,
    *properties.CLASSES,
    *patch_operators.CLASSES,
    *patch_list_operators.CLASSES,
    *patch_source_operators.CLASSES,
    *field_operators.CLASSES,
    *lists.CLASSES,
    *panels.CLASSES,
)


def register() -> None:
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.dirichlet = bpy.props.PointerProperty(
        type=properties.DirichletSettings,
        name="Dirichlet Isolines",
        description="Patches, settings and results of Dirichlet Isolines for this object",
    )


def unregister() -> None:
    del bpy.types.Object.dirichlet
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
