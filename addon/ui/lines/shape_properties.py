# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to isolines once they are extracted."""

from bpy.props import FloatProperty, IntProperty

from .. import callbacks


def _length(name: str, description: str) -> FloatProperty:
    """A fraction of the diagonal of the mesh's bounding box."""
    return FloatProperty(
        name=name,
        description=description,
        min=0.0,
        soft_max=0.1,
        precision=4,
        step=0.02,
        update=callbacks.lines_changed,
    )


def _factor(name: str, description: str) -> FloatProperty:
    return FloatProperty(
        name=name, description=description, default=1.0, min=0.0, soft_max=4.0, update=callbacks.lines_changed
    )


class ShapeSettings:
    """A part of LineSettings."""

    min_length: _length(
        "Shortest",
        "Leave out lines shorter than this, a fraction of the diagonal of the mesh's bounding box; 0 keeps all",
    )
    smooth: IntProperty(
        name="Smooth",
        description="Steps of smoothing, in which the lines stay on the surface and their ends where they are",
        min=0,
        soft_max=50,
        update=callbacks.lines_changed,
    )
    resample: _length(
        "Spacing",
        "Distance along the line between points, a fraction of the diagonal of the mesh's bounding box; 0 leaves a "
        "point on every edge of the mesh that is crossed",
    )
    simplify: _length(
        "Simplify",
        "Leave out points that are no further than this from the line without them, a fraction of the diagonal of the "
        "mesh's bounding box; 0 keeps all",
    )
    bevel_low: _factor("Thickness Low", "Factor of the thickness at the low end of the window")
    bevel_high: _factor(
        "Thickness High", "Factor of the thickness at the high end of the window; it changes evenly in between"
    )
