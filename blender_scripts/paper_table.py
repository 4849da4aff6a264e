# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 1 of "Dirichlet Surface Isolines" for any mesh, our columns beside the paper's, in milliseconds.

python3 blender_scripts/paper_table.py MESH… [--runs 5] [--subdivide N] [--skip-lscg] [--skip-solve]
blender --background --python blender_scripts/paper_table.py -- MESH…
"""

import argparse
import re
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from addon_loader import NotFoundError, load_library, script_words
from painting_discs import far_apart_discs, spread_values

PAPER = {  # milliseconds
    "paper: Dragon": {"vertices": 14101, "connectivity": 710, "least squares": 6870, "10": 15, "13": 24},
    "paper: Fertility": {"vertices": 4994, "connectivity": 96, "least squares": 820, "10": 4.4, "13": 5.6},
}
ROWS = (  # key, label
    ("vertices", "vertices"),
    ("connectivity", "mesh connectivity"),
    ("laplacian", "Laplacian"),
    ("analysis", "ordering and symbolic analysis"),
    ("injection", "injection"),
    ("factorisation", "factorisation"),
    ("solve", "direct solve"),
    ("direct", "harmonic solver, direct: all of these five"),
    ("least squares", "harmonic solver, least-squares CG"),
    ("10", "10 isolines"),
    ("13", "13 isolines"),
    ("total", "arrays in, direct field and 13 isolines out"),
    ("residual", "relative residual, direct"),
    ("memory", "peak memory, Python and NumPy included, MB"),
)


def measure(surface: ModuleType, positions: Any, faces: Any, options: argparse.Namespace) -> dict[str, float]:
    """One column of the table: medians over the runs. Arrays go in, so that reading the file does not count."""
    mesh = surface.Mesh(positions, faces)
    vertices, values = spread_values([np.array([0])] if options.skip_solve else far_apart_discs(mesh))
    count = mesh.vertex_count
    del mesh
    forget_peak_memory()
    runs = [run(surface, positions, faces, vertices, values, options) for _ in range(options.runs)]
    column = {key: float(np.median([single[key] for single in runs])) for key in runs[0]}
    column["vertices"] = count
    column["memory"] = peak_memory()
    if count <= options.lscg_limit:
        report = surface.solve(surface.Mesh(positions, faces), vertices, values, method="lscg").report
        column["least squares"] = 1000 * (report.seconds["factorisation"] + report.seconds["solve"])
    return column


def run(
    surface: ModuleType, positions: Any, faces: Any, vertices: Any, values: Any, options: argparse.Namespace
) -> dict[str, float]:
    """Milliseconds of every stage, once."""
    start = time.perf_counter()
    mesh = surface.Mesh(positions, faces)
    if options.skip_solve:  # a coordinate for a field, and the matrix alone
        column = {"laplacian": clocked(lambda: surface.dirichlet_laplacian(mesh, vertices))}
        field = mesh.positions[:, 1].copy()
    else:
        solved = surface.solve(mesh, vertices, values)
        field = solved.values
        column = {stage: 1000 * seconds for stage, seconds in solved.report.seconds.items()}
        stages = ("laplacian", "analysis", "injection", "factorisation", "solve")
        column["direct"] = sum(column[stage] for stage in stages)
        column["residual"] = solved.report.relative_residual
    low, high = np.nanmin(field), np.nanmax(field)
    column["connectivity"] = 1000 * mesh.build_seconds
    column["13"] = 1000 * surface.isolines(mesh, field, surface.even_levels(low, high, 13)).seconds
    column["total"] = 1000 * (time.perf_counter() - start)
    column["10"] = 1000 * surface.isolines(mesh, field, surface.even_levels(low, high, 10)).seconds
    return column


def forget_peak_memory() -> None:
    """So that the next peak is that of the stages, not of the preparations. Linux."""
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")


def peak_memory() -> float:
    """Of this process, Python and NumPy included, in MB."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    return int(re.search(r"VmHWM:\s+(\d+)", status)[1]) / 1024


def clocked(work: Callable[[], Any]) -> float:
    """Milliseconds."""
    start = time.perf_counter()
    work()
    return 1000 * (time.perf_counter() - start)


def subdivide(positions: Any, triangles: Any) -> tuple[Any, Any]:
    """Four triangles for one, and vertices moved a little along an edge, so that no two regions are alike."""
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    keys, middle = np.unique(sides[:, 0] * len(positions) + sides[:, 1], return_inverse=True)
    first, second = keys // len(positions), keys % len(positions)
    place = np.random.default_rng(len(positions)).uniform(0.35, 0.65, (len(keys), 1))
    finer = np.concatenate([positions, positions[first] * place + positions[second] * (1 - place)])
    a, b, c = triangles.T
    ab, bc, ca = len(positions) + middle.reshape(3, -1)
    corners = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return finer, np.stack([np.stack(triangle, axis=1) for triangle in corners], axis=1).reshape(-1, 3)


def shown(key: str, column: dict[str, float]) -> str:
    if key not in column:
        return "–"
    value = column[key]
    if key in ("vertices", "memory"):
        return f"{value:,.0f}"
    return f"{value:.1e}" if key == "residual" else f"{value:,.1f}" if value < 100 else f"{value:,.0f}"


def table(columns: dict[str, dict[str, float]]) -> str:
    """Markdown."""
    cells = [["milliseconds", *columns], *([label, *(shown(key, c) for c in columns.values())] for key, label in ROWS)]
    widths = [max(len(row[i]) for row in cells) for i in range(len(cells[0]))]
    cells.insert(1, ["-" * widths[0], *("-" * (width - 1) + ":" for width in widths[1:])])
    lines = [[row[0].ljust(widths[0]), *(c.rjust(w) for c, w in zip(row[1:], widths[1:]))] for row in cells]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def parse(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="paper_table", description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="*", type=Path, metavar="MESH", help=".obj .ply .off .stl")
    parser.add_argument("--runs", type=int, default=5, help="medians over so many runs (default 5)")
    parser.add_argument("--subdivide", type=int, default=0, metavar="N", help="first refine N times, 4 triangles for 1")
    parser.add_argument("--skip-solve", action="store_true", help="all but the solver, on the field of a coordinate")
    parser.add_argument("--skip-lscg", action="store_true", help="all but least squares")
    parser.add_argument(
        "--lscg-limit", type=int, default=50_000, metavar="V", help="least squares up to V vertices (default 50000)"
    )
    options = parser.parse_args(words)
    if options.runs < 1:
        parser.error("--runs has to be 1 or more")
    if options.skip_lscg or options.skip_solve:
        options.lscg_limit = 0
    return options


def read(surface: ModuleType, path: Path, subdivisions: int) -> tuple[Any, Any]:
    """Positions and faces."""
    mesh = surface.read_mesh(path)
    if not subdivisions:
        return mesh.positions, (mesh.offsets, mesh.corners)
    positions, triangles = mesh.positions, mesh.triangles
    for _ in range(subdivisions):
        positions, triangles = subdivide(positions, triangles)
    return positions, triangles


def main() -> int:
    options = parse(script_words())
    columns = {}
    try:
        surface = load_library()
    except NotFoundError as error:
        print(f"paper_table: {error}", file=sys.stderr)
        return 2
    try:
        for path in options.meshes:
            columns[path.stem] = measure(surface, *read(surface, path, options.subdivide), options)
    except surface.DirichletError as error:
        print(f"paper_table: {error}", file=sys.stderr)
        return 2
    print(table(columns | PAPER))
    if not options.meshes:
        print("\nName meshes to see ours beside it.")
        return 0
    print(f"\nOurs: medians of {options.runs} runs, six discs of 0.5 % of the vertices painted 0 to 1; paper: Table 1.")
    if any("least squares" not in column for column in columns.values()):
        print("Least squares is left out above --lscg-limit vertices, and with --skip-lscg or --skip-solve.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
