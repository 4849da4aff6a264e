# SPDX-License-Identifier: GPL-3.0-or-later
"""A full disk, a folder or file that may not be written, memory that is denied: one sentence, nothing half-written."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest
from dirichlet_surface import CancelledError, CancelToken, HarmonicSolver, SolverError, solve, write_mesh
from dirichlet_surface.output import FIELD_WRITERS, LINE_WRITERS
from mesh_makers import sphere
from outcomes import obj_of, refusal, snapshot

SPHERE = sphere(19, 24)
PAINT = ["--patch", "low=0@0,0,-1,0.2", "--patch", "high=1@0,0,1,0.2"]
OUTPUTS = [*(f"field{ending}" for ending in FIELD_WRITERS), *(f"lines{ending}" for ending in LINE_WRITERS), "r.json"]
MESHES = ["out.obj", "out.ply", "out.off", "out.stl"]


def option(name: str) -> list[str]:
    return [{"field": "--out-field", "lines": "--out-lines"}.get(name.split(".")[0], "--report"), name]


def refused(command, *words: str) -> str:
    return command.refuses("mesh.obj", *PAINT, outputs=words)


@contextmanager
def small_files() -> Iterator[None]:
    """No file can grow beyond 1000 bytes, as on a disk that is full then; a log of the tests could not either."""
    resource = pytest.importorskip("resource")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)


@pytest.mark.parametrize("name", OUTPUTS)
@pytest.mark.parametrize("present", [False, True], ids=["new", "present"])
def test_a_disk_that_fills_up_leaves_what_was_there(command, name, present):
    command.write("mesh.obj", obj_of(SPHERE))
    if present:
        command.write(name, "precious")
    with small_files():
        assert name in refused(command, *option(name))


@pytest.mark.parametrize("name", MESHES)
def test_a_mesh_on_a_disk_that_fills_up_leaves_what_was_there(command, name):
    command.write(name, "precious")
    with small_files():
        assert f"{name} cannot be written: File too large" in refusal(write_mesh, name, SPHERE.mesh())
    assert snapshot() == {name: b"precious"}


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_read_only_folder_is_named_and_left_alone(command, tmp_path, obey_permissions, name):
    command.write("mesh.obj", obj_of(SPHERE))
    tmp_path.chmod(0o555)
    obey_permissions()
    message = refused(command, *option(name))
    assert name in message
    assert "Permission denied" in message


@pytest.mark.parametrize("name", OUTPUTS)
def test_a_read_only_file_is_named_and_left_alone(command, tmp_path, obey_permissions, name):
    command.write("mesh.obj", obj_of(SPHERE))
    command.write(name, "precious")
    os.chmod(name, 0o444)
    tmp_path.chmod(0o777)
    obey_permissions()
    assert f"cannot write '{name}': Permission denied" in refused(command, *option(name))


@pytest.mark.parametrize("name", MESHES)
def test_a_read_only_mesh_file_is_named_and_left_alone(command, tmp_path, obey_permissions, name):
    command.write(name, "precious")
    os.chmod(name, 0o444)
    tmp_path.chmod(0o777)
    obey_permissions()
    assert f"{name} cannot be written: Permission denied" in refusal(write_mesh, name, SPHERE.mesh())
    assert snapshot() == {name: b"precious"}


@pytest.mark.parametrize("name", ["out.obj", "field.csv"])
def test_a_link_stays_one_and_a_file_keeps_its_permissions(command, name):
    command.write("mesh.obj", obj_of(SPHERE))
    command.write("real", "old")
    os.chmod("real", 0o600)
    os.symlink("real", name)
    if name == "out.obj":
        write_mesh(name, SPHERE.mesh())
    else:
        command.accepts("mesh.obj", *PAINT, "--out-field", name)
    assert os.path.islink(name)
    assert os.stat("real").st_mode & 0o777 == 0o600
    assert os.stat("real").st_size > 3


def test_a_writer_that_fails_last_leaves_the_others_unwritten(command):
    command.write("mesh.obj", obj_of(SPHERE))
    command.write("field.npy", "precious")
    with small_files():
        refused(command, "--report", "report.json", "--out-field", "field.npy")


def test_a_process_without_memory_says_so_in_one_sentence(command, package_path):
    command.write("mesh.obj", obj_of(SPHERE))
    limited = (
        "import resource, sys, numpy; from dirichlet_surface.command_line import main; from dirichlet_surface import *;"
        "used = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize();"
        "resource.setrlimit(resource.RLIMIT_AS, (used + 30_000_000, -1));"
        "sys.exit(main(sys.argv[1:]))"
    )
    big = "".join(f"v {k % 1000} {k // 1000} 0\n" for k in range(300_000)) + "f 1 2 3\n"
    command.write("big.obj", big)
    words = [sys.executable, "-c", limited, "big.obj", "--patch", "a=1@0,0,0,1", "--out-field", "field.npy"]
    run = subprocess.run(words, env={**os.environ, "PYTHONPATH": package_path}, capture_output=True, text=True)
    assert (run.returncode, run.stdout) == (2, "")
    assert "memory" in run.stderr
    assert run.stderr.count("\n") == 1
    assert sorted(os.listdir()) == ["big.obj", "mesh.obj"]


def test_a_cancelled_solve_says_so_and_the_next_is_right():
    mesh, token = SPHERE.mesh(), CancelToken()
    solver = HarmonicSolver(mesh, cancel=token)
    token.cancel()
    with pytest.raises(CancelledError):
        solver.paint([0, 50], [0.0, 1.0])
    token.reset()
    np.testing.assert_array_equal(solver.paint([0, 50], [0.0, 1.0]), solve(mesh, [0, 50], [0.0, 1.0]).values)


@pytest.mark.parametrize(
    "options",
    [
        {"method": "lscg", "max_iterations": 1},
        {"method": "multigrid", "max_iterations": 1, "tolerance": 1e-14},
        {"precision": "float32", "max_iterations": 1, "tolerance": 1e-15},
    ],
    ids=["lscg", "multigrid", "float32"],
)
def test_a_solver_that_falls_short_says_how_far_it_came_and_what_else_to_try(options):
    with pytest.raises(SolverError) as caught:
        solve(SPHERE.mesh(), [0, 50], [0.0, 1.0], **options)
    message = str(caught.value)
    assert "after 1 step, short of the tolerance" in message
    assert "tolerance" in message.split(";")[1]


def test_a_factor_beyond_the_memory_budget_is_told_with_both_numbers():
    report = solve(SPHERE.mesh(), [0, 50], [0.0, 1.0], method="direct", memory_budget=1).report
    (message,) = report.warnings
    assert "more than the memory budget of 1 MB" in message
    assert "multigrid takes less" in message
    assert solve(SPHERE.mesh(), [0, 50], [0.0, 1.0], memory_budget=1).report.warnings == ()
