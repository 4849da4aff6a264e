# SPDX-License-Identifier: GPL-3.0-or-later
"""Python threads beside the library."""

import sys
import threading
import time

from dirichlet_surface import HarmonicSolver, solve
from mesh_makers import sphere
from numpy.testing import assert_array_equal
from paintings import random_paint


def test_two_threads_with_one_solver_and_mesh_get_the_same_bits():
    vertices, values = random_paint(4802)
    mesh = sphere(60, 80).mesh()
    solver = HarmonicSolver(mesh, vertices)
    expected = solver.solve(values)
    results = []
    threads = [
        threading.Thread(target=lambda: results.extend(solver.solve(values) for _ in range(5))) for _ in range(2)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 10
    for result in results:
        assert_array_equal(result, expected)


def test_python_runs_on_while_a_field_is_solved():
    soup = sphere(40, 60)
    vertices, values = random_paint(soup.size, share=0.01)
    mesh, entered = soup.mesh(), threading.Event()

    def work():
        entered.set()
        solve(mesh, vertices, values, method="lscg")

    ticks, interval = 0, sys.getswitchinterval()
    sys.setswitchinterval(60)  # nobody is made to give way: only who releases the lock lets others run
    try:
        worker = threading.Thread(target=work)
        worker.start()
        entered.wait()
        while worker.is_alive():
            ticks += 1
            time.sleep(0.0005)
        worker.join()
    finally:
        sys.setswitchinterval(interval)
    assert ticks > 1
