# SPDX-License-Identifier: GPL-3.0-or-later
"""Stopping a solver from another thread."""

import itertools
import threading

import pytest
from dirichlet_surface import CancelledError, CancelToken, HarmonicSolver, InputError, SolverError, solve
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


def test_what_is_no_token_is_refused():
    with pytest.raises(InputError, match="CancelToken"):
        HarmonicSolver(torus(12, 7).mesh(), cancel=threading.Event())
