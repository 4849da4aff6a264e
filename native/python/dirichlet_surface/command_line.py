# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of `python -m dirichlet_surface`, shared with the headless Blender script."""

from __future__ import annotations

import argparse
import dataclasses
import re
import sys
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from ._native import DirichletError, InputError
from ._text import counted
from .field import METHODS, Field, solve
from .lines import Isolines, even_levels, isolines, level_through_point, stepped_levels
from .mesh import Mesh, find_defects, inspect_patches, read_mesh
from .operators import LAPLACIANS
from .output import FIELD_WRITERS, LINE_WRITERS, write_all, write_json
from .painting import OVERLAP_RULES, Patch, combine_patches
from .patch_argument import parse_numbers, parse_patch

REFUSED = 2  # exit code for anything the user can mend

_NEGATIVE_NUMBERS = re.compile(r"-[.\d][-+.,\de]*", re.IGNORECASE)


class OneSentenceParser(argparse.ArgumentParser):
    """Refuses in one sentence, without the usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(REFUSED, f"{self.prog}: {message}\n")


def shield_numbers(words: Iterable[str]) -> list[str]:
    """Command-line words in which argparse takes -1e-3 and -1,0,2 for values, not for options."""
    return [f" {word}" if _NEGATIVE_NUMBERS.fullmatch(word) else word for word in words]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Everything after MESH. Parse words that went through `shield_numbers`."""
    parser.add_argument(
        "--patch", dest="patches", action="append", type=parse_patch, default=[], metavar="NAME=VALUE@PLACE",
        help="paint VALUE on vertices; PLACE is a file of vertex indices from 0, or x,y,z,r: all within r of a point",
    )  # fmt: skip
    parser.add_argument("--overlap", choices=OVERLAP_RULES, default="error", help="for patches that disagree")
    parser.add_argument(
        "--laplacian", choices=LAPLACIANS, default="graph",
        help="; ".join(f"{name}: {when}" for name, when in LAPLACIANS.items()),
    )  # fmt: skip
    parser.add_argument(
        "--method", choices=METHODS, default="auto",
        help="auto (default): direct while it fits half of the memory, else multigrid; lscg: the paper's least squares",
    )  # fmt: skip

    levels = parser.add_mutually_exclusive_group()
    levels.add_argument("--isolines", type=int, metavar="N", help="N levels spread evenly in the window (default 10)")
    levels.add_argument("--levels", type=parse_numbers, metavar="A,B,...", help="these levels")
    levels.add_argument("--step", type=float, metavar="S", help="levels S apart in the window")
    levels.add_argument("--through", type=_point, metavar="X,Y,Z", help="the level through the nearest surface point")
    parser.add_argument("--phase", type=float, metavar="P", help="with --step: shift by P steps (default 0)")
    parser.add_argument(
        "--window", type=float, nargs=2, metavar=("LO", "HI"), help="of --isolines and --step (default: all the field)"
    )

    parser.add_argument("--out-field", type=_file_type(FIELD_WRITERS), metavar="FILE", help=" ".join(FIELD_WRITERS))
    parser.add_argument("--out-lines", type=_file_type(LINE_WRITERS), metavar="FILE", help=" ".join(LINE_WRITERS))
    parser.add_argument("--report", type=_file_type([".json"]), metavar="FILE", help=".json")


def choose_levels(args: argparse.Namespace, mesh: Mesh, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The levels (K,) asked for; none where a constant field leaves no window. Raises InputError."""
    if args.phase is not None and args.step is None:
        raise InputError("--phase goes with --step")
    if args.levels is not None or args.through is not None:
        if args.window is not None:
            raise InputError("--window goes with --isolines or --step")
        return np.array(args.levels or [level_through_point(mesh, values, args.through)])
    low, high = args.window or (np.nanmin(values), np.nanmax(values))
    constant = args.window is None and low == high
    if constant:  # levels are checked all the same, in a window that any step fits into
        low, high = 0.0, np.finfo(float).tiny
    if args.step is not None:
        levels = stepped_levels(low, high, args.step, args.phase or 0.0)
    else:
        levels = even_levels(low, high, 10 if args.isolines is None else args.isolines)
    return levels[:0] if constant else levels


def write_outputs(
    args: argparse.Namespace,
    mesh: Mesh,
    field: Field,
    lines: Isolines,
    patches: Sequence[Patch] = (),
    warnings: Sequence[str] = (),
    also: Sequence[tuple[Path, Callable[[Path], None]]] = (),
) -> None:
    """Writes the files asked for, and `also` those, all or none; `warnings` come first in the report. Raises
    InputError."""
    files = list(also)
    if args.out_field:
        files.append((args.out_field, partial(FIELD_WRITERS[args.out_field.suffix.lower()], mesh, field)))
    if args.out_lines:
        files.append((args.out_lines, partial(LINE_WRITERS[args.out_lines.suffix.lower()], mesh, lines)))
    if args.report:
        files.append((args.report, partial(write_json, make_report(mesh, field, lines, patches, warnings))))
    write_all(files)


def make_report(
    mesh: Mesh, field: Field, lines: Isolines, patches: Sequence[Patch], warnings: Sequence[str]
) -> dict[str, Any]:
    """Everything known about a run, ready for JSON."""
    closed = int(np.count_nonzero(lines.closed))
    defects = find_defects(mesh)
    facts = inspect_patches(mesh, [patch.vertices for patch in patches])
    return {
        "mesh": {
            "vertices": mesh.vertex_count,
            "edges": mesh.edge_count,
            "faces": mesh.face_count,
            "components": mesh.components()[1],
            "border_loops": len(mesh.border_loops()[0]) - 1,
            "repeated_faces": defects.repeated_faces,
            "flat_faces": defects.flat_faces,
            "crossing_faces": defects.crossing_faces,
            "coincident_vertices": defects.coincident_vertices,
        },
        "patches": [
            {"name": patch.name, "value": np.asarray(patch.values, dtype=float).tolist(), **dataclasses.asdict(fact)}
            for patch, fact in zip(patches, facts)
        ],
        "solve": field.report.to_dict(),
        "isolines": {
            "levels": lines.levels.tolist(),
            "lines": len(lines),
            "closed": closed,
            "open": len(lines) - closed,
            "length": float(lines.length.sum()),
            "seconds": lines.seconds,
        },
        "warnings": [*warnings, *field.report.warnings, *lines.warnings],
    }


def _point(text: str) -> tuple[float, ...]:
    numbers = parse_numbers(text)
    if len(numbers) != 3:
        raise argparse.ArgumentTypeError(f"'{text}' is not x,y,z")
    return numbers


def _file_type(endings: Iterable[str]) -> Callable[[str], Path]:
    """An argparse type: a path with one of these endings, so that others are refused before any work."""

    def file_type(text: str) -> Path:
        path = Path(text)
        if path.suffix.lower() not in endings:
            raise argparse.ArgumentTypeError(f"'{text}' does not end in {' or '.join(endings)}")
        return path

    return file_type


def run(args: argparse.Namespace) -> str:
    """Mesh file to output files; returns the summary. Raises DirichletError, and then has written nothing."""
    mesh = read_mesh(args.mesh)
    patches = [patch.to_patch(mesh.positions) for patch in args.patches]
    painting = combine_patches(patches, mesh.vertex_count, args.overlap)
    field = solve(mesh, painting.vertices, painting.values, laplacian=args.laplacian, method=args.method)
    lines = isolines(mesh, field.values, choose_levels(args, mesh, field.values))
    write_outputs(args, mesh, field, lines, patches, painting.warnings)
    closed = int(np.count_nonzero(lines.closed))
    return "\n".join(
        [
            f"{args.mesh}: {counted(mesh.vertex_count, 'vertex')}, {counted(mesh.face_count, 'face')}",
            f"field: {field.report.summary()}",
            *([f"laplacian: {taken.laplacian}, as {taken.reason}"] if (taken := field.report).reason else []),
            f"isolines: {len(lines)} on {counted(len(lines.levels), 'level')}, {closed} closed, "
            f"{len(lines) - closed} open",
            *(f"warning: {text}" for text in (*painting.warnings, *field.report.warnings, *lines.warnings)),
            *(f"wrote {path}" for path in (args.out_field, args.out_lines, args.report) if path),
        ]
    )


def main(words: Sequence[str] | None = None) -> int:
    """The command; returns its exit code: 0, or 2 after one sentence on stderr."""
    parser = OneSentenceParser(
        prog="dirichlet_surface", description="Harmonic field of painted patches on a mesh, and its isolines."
    )
    parser.add_argument("mesh", metavar="MESH", type=Path, help=".obj .ply .off .stl")
    add_arguments(parser)
    args = parser.parse_args(shield_numbers(sys.argv[1:] if words is None else words))
    try:
        summary = run(args)
    except (DirichletError, MemoryError) as error:
        print(f"{parser.prog}: {str(error) or 'there is not enough memory for this'}", file=sys.stderr)
        return REFUSED
    encoding = sys.stdout.encoding or "utf-8"
    print(summary.encode(encoding, "backslashreplace").decode(encoding))  # names that are no text
    return 0
