# SPDX-License-Identifier: GPL-3.0-or-later
"""What the last runs measured, kept with the object for the panel and for scripts."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from .field.laplacians import LAPLACIANS


class DirichletResults(bpy.types.PropertyGroup):
    """Object.dirichlet.results"""

    solved: BoolProperty(name="Solved", description="Solve Field has run on this object")
    vertices: IntProperty(name="Vertices", description="Vertices of the mesh")
    painted: IntProperty(name="Painted", description="Vertices with a prescribed value")
    unknowns: IntProperty(name="Unknowns", description="Free vertices, whose values were solved for")
    laplacian: EnumProperty(
        name="Laplacian", description="The Laplacian solved with, never the automatic one", items=LAPLACIANS
    )
    reason: StringProperty(name="Reason", description="Why the automatic choice took that Laplacian")
    undefined: IntProperty(
        name="Undefined", description="Vertices of pieces without paint: NaN in the field, grey in the picture"
    )
    residual: FloatProperty(
        name="Residual", description="Relative residual of the linear system: norm of its error over norm of its right"
    )
    minimum: FloatProperty(name="Minimum", description="Lowest value of the field")
    maximum: FloatProperty(name="Maximum", description="Highest value of the field", default=1.0)
    connectivity_ms: FloatProperty(
        name="Connectivity", description="Milliseconds to check the mesh and find which vertices and faces touch"
    )
    solver_ms: FloatProperty(
        name="Solver", description="Milliseconds for Laplacian, analysis, injection, factorisation and solve together"
    )
    fingerprint: StringProperty(
        name="Fingerprint",
        description="Of what was solved for: tells whether patches, Laplacian or shape changed since",
    )
    problem: StringProperty(name="Problem", description="Why the field or its lines could not follow the last change")
    field_warnings: StringProperty(name="Field Warnings", description="Warnings of the last solve, one a line")
    extracted: BoolProperty(name="Extracted", description="Make Isolines has run on the field solved last")
    isolines_ms: FloatProperty(name="Isolines", description="Milliseconds to extract all isolines")
    levels: IntProperty(name="Levels", description="Levels asked for")
    lines: IntProperty(name="Lines", description="Connected isolines")
    closed: IntProperty(name="Closed", description="Isolines that close; the others end on a border")
    isoline_warnings: StringProperty(name="Isoline Warnings", description="Warnings of the last isolines, one a line")
