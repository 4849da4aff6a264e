# SPDX-License-Identifier: GPL-3.0-or-later
"""Who takes part, and how: each library in a process of its own, with a limit to its time."""

import json
import os
import signal
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from .scene import load
from .systems import right_side, whole

ROOT = Path(__file__).resolve().parents[3]
PEERS = ROOT / "build/bench/native/bench/dirichlet_peers"
PEER_PYTHON = ROOT / "build/bench-venv/bin/python"
OPENBLAS = Path("/usr/lib") / f"{os.uname().machine}-linux-gnu" / "openblas-pthread"
WORST_RESIDUAL = 1e-7
CORES = len(os.sched_getaffinity(0))
FEW_FROM = 1_500_000
"""vertices, beyond which, as on meshes of an odd kind, nobody runs on one thread who can use more"""
OURS_ALONE_FROM = 5_000_000


@dataclass(frozen=True)
class Contestant:
    label: str
    command: tuple[str | Path, ...]
    threads: int = CORES
    any_matrix: bool = False
    """solves with the matrix of the scene; the others make their own from the mesh"""

    @property
    def title(self) -> str:
        return f"{self.label}, {self.threads} thread{'s'[: self.threads > 1]}"


@dataclass
class Result:
    """What a contestant said before it ended."""

    title: str
    trouble: str = ""
    wall: dict[str, list[float]] = field(default_factory=dict)
    """seconds of every run of a stage"""
    user: dict[str, list[float]] = field(default_factory=dict)
    facts: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Effort:
    runs: int
    seconds: float
    """of one stage, after which no further run of it begins"""
    limit: float
    """seconds of one contestant on one scene"""


def by_python(label: str, module: str, threads: int = CORES, any_matrix: bool = False) -> Contestant:
    ours = module.startswith("ours")  # the library serves the Python it was built for, peers that of their own folder
    command = (sys.executable if ours else PEER_PYTHON, "-m", f"{__package__}.contestant", module)
    return Contestant(label, command, threads, any_matrix)


def every_contestant() -> list[Contestant]:
    """Ours first."""
    counts = sorted({1, CORES}, reverse=True)
    solvers = [by_python("ours", "ours", threads) for threads in counts]
    solvers += [by_python(f"ours {variant}", f"ours:{variant}") for variant in ("float32", "multigrid")]
    direct = {"ours matrix": "ours", "CHOLMOD, AMD": "cholmod-amd", "CHOLMOD, METIS": "cholmod-metis"}
    solvers += [Contestant(label, (PEERS, name), n, True) for label, name in direct.items() for n in counts]
    solvers += [by_python("PARDISO", "pardiso", threads, True) for threads in counts]
    solvers.append(Contestant("Eigen LDLT", (PEERS, "eigen"), 1, True))
    solvers.append(by_python("pyamg", "multigrid", 1, True))
    lines = [by_python("ours lines", "ours_lines", threads) for threads in counts]
    lines += [by_python("VTK", "vtk_contour"), by_python("potpourri3d", "potpourri", 1)]
    return [*solvers, by_python("libigl", "libigl"), *lines, Contestant("OpenMesh", (PEERS, "openmesh"), 1)]


def taking_part(name: str, count: int, words: list[str] | None) -> list[Contestant]:
    """On the scene of that name and number of vertices, those with one of these words in their titles."""
    found = every_contestant()
    if name.endswith("cotangent"):
        found = [one for one in found if one.any_matrix]
    if count > FEW_FROM or " " in name:
        with_all_cores = {one.label: one for one in reversed(found)}
        found = [one for one in found if with_all_cores[one.label] is one]
    if count > OURS_ALONE_FROM:
        found = [one for one in found if one.label in ("ours", "ours float32", "ours multigrid", "ours lines")]
    return [one for one in found if not words or any(word.lower() in one.title.lower() for word in words)]


def surroundings(threads: int) -> dict[str, str]:
    """Tuned libraries: Debian's OpenBLAS may mistake the processor; threads that wait must not keep the others from
    the cores."""
    flags = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    core = "SKYLAKEX" if " avx512f" in flags else "HASWELL" if " avx2" in flags else ""
    limits = ("OMP_THREAD_LIMIT", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
    return {
        **os.environ,
        **dict.fromkeys(limits, str(threads)),
        **({"OPENBLAS_CORETYPE": core} if core else {}),
        "OMP_WAIT_POLICY": "passive",
        "LD_LIBRARY_PATH": os.pathsep.join(filter(None, [str(OPENBLAS), os.environ.get("LD_LIBRARY_PATH")])),
    }


def compete(contestant: Contestant, folder: Path, effort: Effort) -> Result:
    """Never fails: what goes wrong is part of the result."""
    result = Result(contestant.title)
    field_file = folder / "field.npy"
    field_file.unlink(missing_ok=True)
    words = [*contestant.command, folder, field_file, str(effort.runs), str(effort.seconds)]
    if not Path(contestant.command[0]).exists():
        result.trouble = f"missing: there is no {Path(contestant.command[0]).name} of the benchmark"
        return result
    output, result.trouble = run_limited(words, contestant.threads, effort.limit)
    for line in output.splitlines():
        if line.startswith('{"'):
            note(json.loads(line), result)
    if "missing" in result.facts:
        result.trouble = f"missing: {result.facts['missing']}"
    if field_file.exists():
        result.facts |= judge(np.load(field_file), folder)
        field_file.unlink()
        if not result.facts["residual"] < WORST_RESIDUAL:
            result.trouble = f"not solved, so that its times do not count: residual {result.facts['residual']:.1e}"
            result.wall, result.user = {}, {}
    return result


def run_limited(words: list[Any], threads: int, limit: float) -> tuple[str, str]:
    """What it printed, and what went wrong: nothing, hopefully."""
    cores = sorted(os.sched_getaffinity(0))[:threads]
    process = subprocess.Popen(
        words,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=surroundings(threads),
        preexec_fn=lambda: os.sched_setaffinity(0, cores),  # a thread more than asked for gains nothing
    )
    try:
        output, complaints = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        process.kill()
        return process.communicate()[0], f"stopped after {limit:.0f} s"
    if process.returncode == 0:
        return output, ""
    end = complaints.strip().splitlines()[-1:] or [describe_end(process.returncode)]
    return output, f"failed: {end[0]}"


def describe_end(code: int) -> str:
    return signal.Signals(-code).name if code < 0 else f"exit code {code}"


def note(line: dict[str, Any], result: Result) -> None:
    if "stage" in line:
        result.wall.setdefault(line["stage"], []).append(line["wall"])
        if line["user"] is not None:
            result.user.setdefault(line["stage"], []).append(line["user"])
    elif line["fact"].startswith(("later", "stroke", "dab")):  # one of each run
        result.facts.setdefault(line["fact"], []).append(line["value"])
    else:
        result.facts[line["fact"]] = line["value"]


def judge(values: Any, folder: Path) -> dict[str, float]:
    """How well the field of the first painting was solved; the error only where that field is known."""
    scene = load(folder)  # only now: while a contestant runs, the memory is its own
    free = np.isnan(scene.first)
    rhs = right_side(scene.stiffness, scene.first)[free]
    residual = (whole(scene.stiffness) @ values)[free]  # painted values bring the right-hand side with them
    result = {"residual": float(np.linalg.norm(residual) / np.linalg.norm(rhs))}
    if scene.reference.size:
        result["error"] = float(np.abs(values - scene.reference).max())
    return result
