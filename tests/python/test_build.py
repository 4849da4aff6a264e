# SPDX-License-Identifier: GPL-3.0-or-later
"""What the library says of itself, and how many threads it takes."""

import os
import re
from pathlib import Path

import dirichlet_surface as surface
import numpy as np
import pytest
from dirichlet_surface import InputError, build_information, default_memory_budget, set_thread_limit
from mesh_makers import torus
from paintings import random_paint

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def limited():
    yield set_thread_limit
    set_thread_limit(None)


def test_solvers_keep_to_half_of_the_machines_memory():
    assert default_memory_budget() == os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2


def test_what_a_report_needs_is_told():
    told = build_information()
    assert set(told) == {"version", "compiler", "eigen", "openmesh", "pybind11", "instruction_set", "cores"}
    assert all(isinstance(text, str) and text for text in told.values())
    assert f"VERSION {told['version']} " in (ROOT / "CMakeLists.txt").read_text()
    assert told["instruction_set"] in ("baseline", "AVX2", "AVX-512")
    assert int(told["cores"]) == os.cpu_count()
    for library in ("eigen", "openmesh", "pybind11"):
        assert re.fullmatch(r"\d+(\.\d+)+", told[library])


def everything(mesh, vertices, values) -> list[np.ndarray]:
    """One array or more of all that the library shares out."""
    solvers = [surface.HarmonicSolver(mesh, vertices, method=method) for method in ("direct", "multigrid")]
    fields = [solver.solve(values) for solver in solvers]
    field = fields[0]
    lines = surface.isolines(mesh, field, surface.even_levels(-3, 3, 90))
    shaped = [
        surface.smooth_lines(mesh, lines, 5),
        surface.simplify_lines(lines, 0.01),
        surface.resample_lines(lines, 0.02),
    ]
    levels = [surface.equal_area_levels(mesh, field, 9), surface.equal_distance_levels(mesh, field, 9)]
    disc = surface.geodesic_disc(mesh, [2.1, 0.3, 0.6], 1.0)
    return [*fields, *(one.points for one in (lines, *shaped)), *(one.length for one in shaped), *levels, *disc]


def test_results_are_the_same_bit_for_bit_however_many_threads_there_are(limited):
    soup = torus(240, 140)
    vertices, values = random_paint(soup.size, share=0.01)
    results = []
    for count in (1, 2, None):
        limited(count)
        results.append(everything(soup.mesh(), vertices, values))
    for others in results[1:]:
        for one, other in zip(results[0], others, strict=True):
            np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("count", [0, -1, 1.5, "2", 2**40])
def test_a_number_of_threads_that_is_none_is_refused(limited, count):
    with pytest.raises(InputError, match="the number of threads"):
        limited(count)
