# SPDX-License-Identifier: GPL-3.0-or-later
"""What a result remembers: the mesh object it was made of, and how."""

import bpy
from bpy.props import BoolProperty, PointerProperty

from .. import callbacks
from .line_properties import LineSettings


class DirichletIsolines(LineSettings, bpy.types.PropertyGroup):
    """Object.dirichlet_isolines"""

    source: PointerProperty(
        type=bpy.types.Object,
        name="Source",
        description="Mesh object that these isolines are made of",
        poll=callbacks.is_other_mesh,
    )
    locked: BoolProperty(
        name="Lock",
        description="Keep these isolines as they are: nothing refreshes them, and Make Isolines makes another object",
    )
    follow: BoolProperty(
        name="Follow",
        description="Refresh these isolines when field, settings or frame change, and draw them on the shape that "
        "armature, shape keys and modifiers give the mesh, as long as those keep its faces. Rendering from the window "
        "needs Render > Lock Interface then",
        update=callbacks.follow_changed,
    )

    @property
    def results(self):
        """What the field measured."""
        return (self.source or self.id_data).dirichlet.results


CLASSES = (DirichletIsolines,)
