# SPDX-License-Identifier: GPL-3.0-or-later
"""Dirichlet Isolines: harmonic fields between painted patches of a mesh, and their isolines."""

from . import ui

bl_info = {  # for Blender before 4.2; later ones read blender_manifest.toml
    "name": "Dirichlet Isolines",
    "author": "Dirichlet Isolines contributors",
    "version": (0, 0, 0),  # filled in from CMakeLists.txt
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar (N) > Isolines",
    "description": "Harmonic fields between painted patches, and their isolines",
    "category": "Mesh",
}


def register() -> None:
    ui.register()


def unregister() -> None:
    ui.unregister()
