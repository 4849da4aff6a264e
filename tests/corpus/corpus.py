# SPDX-License-Identifier: GPL-3.0-or-later
"""Every mesh of a folder with every painting and every Laplacian: a table, and at its end what failed and why.

    corpus.py [--table FILE] [--limit SECONDS] FOLDER-OR-MESH…

Exit code 0: nothing failed (a clear refusal is none), 1: something did, 2: no mesh was found.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Iterator
from itertools import groupby, product
from pathlib import Path

from cases import PAINTINGS, Case, Outcome, check
from dirichlet_surface import LAPLACIANS
from isolation import NoResultError, results

ENDINGS = {".obj", ".ply", ".off", ".stl"}
HEAD = f"{'mesh':48} {'Laplacian':18} {'vertices':>8} {'faces':>8} {'status':8} {'outside':>16} {'open':>5} {'ms':>8}"


def find_files(places: list[Path]) -> tuple[list[Path], list[Path]]:
    """Meshes, and what else there is."""
    files = [file for place in places for file in (sorted(place.rglob("*")) if place.is_dir() else [place])]
    files = [file for file in files if not file.is_dir()]
    meshes = [file for file in files if file.suffix.lower() in ENDINGS]
    return meshes, [file for file in files if file not in meshes]


def outcomes(meshes: list[Path], limit: float) -> Iterator[tuple[Case, Outcome]]:
    def seconds_for(case: Case) -> float:  # five megabytes hold more than 50 000 vertices in every format
        return limit * max(1.0, case.path.stat().st_size / 5e6)

    cases = [Case(*names) for names in product(meshes, LAPLACIANS, PAINTINGS)]
    for case, result in zip(cases, results(check, cases, seconds_for)):
        yield case, Outcome("failed", str(result)) if isinstance(result, NoResultError) else result


def row(mesh: Path, laplacian: str, group: list[Outcome]) -> str:
    """All paintings of a mesh with one Laplacian."""
    size = max(group, key=lambda outcome: outcome.vertices)
    status = max((outcome.status for outcome in group), key=["passed", "refused", "failed"].index)
    outside = sum(outcome.outside for outcome in group)
    how_far = f"{outside} ({100 * max(outcome.farthest for outcome in group):.2g} %)" if outside else "0"
    open_ends, seconds = (sum(getattr(outcome, name) for outcome in group) for name in ("open_ends", "seconds"))
    return (
        f"{mesh.name[:48]:48} {laplacian:18} {size.vertices:8} {size.faces:8} {status:8} {how_far:>16} "
        f"{open_ends:5} {1000 * seconds:8.1f}"
    )


def run(meshes: list[Path], limit: float) -> Iterator[tuple[str, dict[Case, Outcome]]]:
    """The table's rows, each with what it is made of."""
    for (mesh, laplacian), group in groupby(outcomes(meshes, limit), key=lambda item: item[0][:2]):
        of_row = dict(group)
        yield row(mesh, laplacian, list(of_row.values())), of_row


def reasons(all_cases: dict[Case, Outcome], status: str) -> list[str]:
    """Each reason once per mesh, with the cases it stands for."""
    cases: dict[tuple[str, str], list[Case]] = {}
    for case, outcome in all_cases.items():
        if outcome.status == status:
            cases.setdefault((case.path.name, outcome.why), []).append(case)
    lines = []
    for (name, why), same in cases.items():
        kinds = [", ".join(sorted({getattr(case, part) for case in same})) for part in ("laplacian", "painting")]
        lines.append(f"  {name} [{'; '.join(kinds)}]: {why}")
    return lines


def main(words: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("places", nargs="+", type=Path, metavar="FOLDER-OR-MESH")
    parser.add_argument("--table", type=Path, metavar="FILE", help="write what is printed there, too")
    parser.add_argument(
        "--limit", type=float, default=10, metavar="SECONDS",
        help="for a case of fewer than 50 000 vertices (default 10), in proportion above; then it counts as hung",
    )  # fmt: skip
    args = parser.parse_args(words)
    if missing := [str(place) for place in args.places if not place.exists()]:
        parser.error(f"there is no {missing[0]}" + (f" (and {len(missing) - 1} more)" if missing[1:] else ""))
    meshes, others = find_files(args.places)
    start, printed, all_cases = time.perf_counter(), [], {}

    def say(line: str) -> None:
        print(line, flush=True)
        printed.append(line)

    say(HEAD)
    for line, group in run(meshes, args.limit):
        say(line)
        all_cases |= group
    for title, lines in (
        ("Not readable", [f"  {file.name}: no mesh format that is known" for file in others]),
        ("Refused", reasons(all_cases, "refused")),
        ("Failed", reasons(all_cases, "failed")),
    ):
        if lines:
            say("\n".join([f"\n{title}", *lines]))
    count = Counter(outcome.status for outcome in all_cases.values())
    say(
        f"\n{len(meshes)} meshes, {len(all_cases)} cases: {count['passed']} passed, {count['refused']} refused, "
        f"{count['failed']} failed, in {time.perf_counter() - start:.0f} s"
    )
    if args.table:
        args.table.parent.mkdir(parents=True, exist_ok=True)
        args.table.write_text("\n".join(printed) + "\n", encoding="utf-8")
    return 1 if count["failed"] else 0 if meshes else 2


if __name__ == "__main__":
    sys.exit(main())
