# SPDX-License-Identifier: GPL-3.0-or-later
"""Properties, operators, lists and panels. No maths and no loops over vertices."""

import bpy

from . import computing, handlers, panels, preferences, properties, translations
from .drawing import legend, preview, preview_panel
from .field import field_operators, preset_operators, presets_panel, stripe_operators, stripe_panel
from .lines import pick_operators, result_object_properties, result_operators, result_panels, shape_panels
from .patches import add_patch_operator, lists, patch_list_operators, patch_operators, patch_source_operators, tools

_MODULES = (
    preferences,
    properties,
    result_object_properties,
    patch_operators,
    patch_list_operators,
    patch_source_operators,
    add_patch_operator,
    computing,
    field_operators,
    pick_operators,
    result_operators,
    preset_operators,
    presets_panel,
    lists,
    panels,
    result_panels,
    shape_panels,
    stripe_operators,
    preview_panel,
    stripe_panel,
)
_HOOKED = (translations, presets_panel, tools, handlers, preview, legend)  # register more than classes
_CLASSES = tuple(cls for module in _MODULES for cls in module.CLASSES)


def register() -> None:
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Object.dirichlet = bpy.props.PointerProperty(
        type=properties.DirichletSettings,
        name="Dirichlet Isolines",
        description="Patches, settings and results of Dirichlet Isolines for this object",
    )
    bpy.types.Object.dirichlet_isolines = bpy.props.PointerProperty(
        type=result_object_properties.DirichletIsolines,
        name="Dirichlet Isolines Result",
        description="What this object's isolines were made of, and how",
    )
    for module in _HOOKED:
        module.register()


def unregister() -> None:
    for module in reversed(_HOOKED):
        module.unregister()
    del bpy.types.Object.dirichlet_isolines
    del bpy.types.Object.dirichlet
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
