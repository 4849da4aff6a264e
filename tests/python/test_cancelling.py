# SPDX-License-Identifier: GPL-3.0-or-later
"""Stopping work from another thread."""

import itertools
import threading

import pytest
from dirichlet_surface import (
    CancelledError,
    CancelToken,
    HarmonicSolver,
    InputError,
    SolverError,
    equal_area_levels,
    equal_distance_levels,
    geodesic_disc,
    isolines,
    resample_lines,
    simplify_lines,
    smooth_lines,
    solve,
)
from mesh_makers import torus
from numpy.testing import assert_array_equal
from paintings import random_paint


def test_a_solver_that_is_stopped_in_its_work_can_be_painted_again():
    soup, token = torus(120, 80), CancelToken()
    mesh = soup.mesh()
    vertices, values = random_paint(soup.size)
    solver, outcome, begun = HarmonicSolver(mesh, cancel=token), [], threading.Event()

    def work():
        try:
            for number in itertools.count():
                solver.paint(vertices[: 50 + number % 50], values[: 50 + number % 50])
                begun.set()
        except SolverError as error:
            outcome.append(error)

    worker = threading.Thread(target=work)
    worker.start()
    begun.wait()
    token.cancel()
    worker.join()
    assert type(outcome[0]) is CancelledError
    assert token.is_cancelled
    with pytest.raises(CancelledError):
        solver.paint(vertices[:9], values[:9])
    token.reset()
    with pytest.raises(InputError, match="no vertex is painted"):
        solver.solve(values)
    assert_array_equal(solver.paint(vertices, values), solve(mesh, vertices, values).values)


def test_nothing_begins_while_the_token_is_raised():
    soup, token = torus(12, 7), CancelToken()
    token.cancel()
    with pytest.raises(CancelledError, match="cancelled"):
        HarmonicSolver(soup.mesh(), [0, 1], cancel=token)
    token.reset()
    HarmonicSolver(soup.mesh(), [0, 1], cancel=token).solve([0.0, 1.0])


def works(soup):
    """What can take long with lines, by name: called with a token."""
    mesh = soup.mesh()
    field = mesh.positions[:, 0].copy()
    lines = isolines(mesh, field, [0.0, 1.0])
    return {
        "isolines": lambda token: isolines(mesh, field, [0.0, 1.0], cancel=token).points,
        "smooth_lines": lambda token: smooth_lines(mesh, lines, 3, cancel=token).points,
        "simplify_lines": lambda token: simplify_lines(lines, 0.1, cancel=token).points,
        "resample_lines": lambda token: resample_lines(lines, 0.1, cancel=token).points,
        "equal_area_levels": lambda token: equal_area_levels(mesh, field, 5, cancel=token),
        "equal_distance_levels": lambda token: equal_distance_levels(mesh, field, 5, cancel=token),
        "geodesic_disc": lambda token: geodesic_disc(mesh, mesh.positions[3], 1.0, cancel=token)[1],
    }


@pytest.mark.parametrize("name", works(torus(12, 7)))
def test_work_on_lines_ends_by_a_raised_token_and_is_the_same_without(name):
    work, token = works(torus(40, 30))[name], CancelToken()
    token.cancel()
    with pytest.raises(CancelledError, match="cancelled"):
        work(token)
    token.reset()
    assert_array_equal(work(token), work(None))


def test_smoothing_is_stopped_on_its_way():
    soup, token = torus(400, 300), CancelToken()
    mesh = soup.mesh()
    lines = isolines(mesh, mesh.positions[:, 0].copy(), [0.0, 0.5, 1.0])

    def smooth_on():
        while True:
            smooth_lines(mesh, lines, 10_000, cancel=token)

    timer = threading.Timer(0.05, token.cancel)
    timer.start()
    with pytest.raises(CancelledError):
        smooth_on()
    timer.join()


def test_what_is_no_token_is_refused():
    with pytest.raises(InputError, match="CancelToken"):
        HarmonicSolver(torus(12, 7).mesh(), cancel=threading.Event())
    for work in works(torus(12, 7)).values():
        with pytest.raises(InputError, match="CancelToken"):
            work(threading.Event())
