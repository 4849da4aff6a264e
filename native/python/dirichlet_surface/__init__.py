# SPDX-License-Identifier: GPL-3.0-or-later
"""Harmonic fields and isolines on surfaces, with painted patches injected as strong Dirichlet conditions.

    mesh = read_mesh("dragon.ply")
    field = solve(mesh, vertices, values)
    lines = isolines(mesh, field.values, even_levels(0, 1, 13))

All errors are DirichletError: InputError, TopologyError or SolverError, one sentence that names what and where.
"""

from ._native import CancelledError, DirichletError, InputError, SolverError, TopologyError
from .build import build_information, default_memory_budget, set_thread_limit
from .cancel import CancelToken
from .field import Field, HarmonicSolver, SolveReport, solve
from .geodesic import geodesic_disc
from .line_shaping import keep_long, move_lines, resample_lines, simplify_lines, smooth_lines
from .lines import (
    Isolines,
    equal_area_levels,
    equal_distance_levels,
    even_levels,
    isolines,
    level_through_point,
    stepped_levels,
)
from .mesh import Defects, Mesh, PatchFacts, find_defects, inspect_patches, read_mesh, write_mesh
from .operators import LAPLACIANS, CsrMatrix, dirichlet_laplacian, lumped_mass, stiffness_matrix
from .painting import Painting, Patch, combine_patches

__all__ = [
    "LAPLACIANS",
    "CancelToken",
    "CancelledError",
    "CsrMatrix",
    "Defects",
    "DirichletError",
    "Field",
    "HarmonicSolver",
    "InputError",
    "Isolines",
    "Mesh",
    "Painting",
    "Patch",
    "PatchFacts",
    "SolveReport",
    "SolverError",
    "TopologyError",
    "build_information",
    "combine_patches",
    "default_memory_budget",
    "dirichlet_laplacian",
    "equal_area_levels",
    "equal_distance_levels",
    "even_levels",
    "find_defects",
    "geodesic_disc",
    "inspect_patches",
    "isolines",
    "keep_long",
    "level_through_point",
    "lumped_mass",
    "move_lines",
    "read_mesh",
    "resample_lines",
    "set_thread_limit",
    "simplify_lines",
    "smooth_lines",
    "solve",
    "stepped_levels",
    "stiffness_matrix",
    "write_mesh",
]
