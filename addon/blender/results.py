# SPDX-License-Identifier: GPL-3.0-or-later
"""What the last runs measured, kept with the object for the panel and for scripts."""

from __future__ import annotations

import bpy
import numpy as np


def record_field(results: bpy.types.PropertyGroup, solved) -> None:
    """solved: pipeline.FieldResult. Forgets the isolines of the field before."""
    report, seconds = solved.field.report, solved.seconds
    results.solved, results.extracted = True, False
    results.vertices, results.painted, results.unknowns = report.vertices, report.painted, report.unknowns
    results.laplacian, results.reason = report.laplacian, report.reason
    results.undefined = report.undefined
    results.residual = report.relative_residual
    results.minimum, results.maximum = report.minimum, report.maximum
    results.connectivity_ms = 1000 * seconds["connectivity"]
    stages = ("laplacian", "analysis", "injection", "factorisation", "solve")
    results.solver_ms = 1000 * sum(seconds[stage] for stage in stages)
    results.fingerprint = solved.fingerprint
    results.field_warnings = "\n".join(solved.warnings)


def record_isolines(results: bpy.types.PropertyGroup, made) -> None:
    """made: pipeline.IsolineResult."""
    closed = np.asarray(made.lines.closed, bool)
    results.extracted = True
    results.isolines_ms = 1000 * made.seconds["isolines"]
    results.levels, results.lines, results.closed = len(made.lines.levels), len(closed), int(closed.sum())
    results.isoline_warnings = "\n".join(made.warnings)
