# SPDX-License-Identifier: GPL-3.0-or-later
"""The measurements as Markdown. `data` is what report.json holds."""

from collections import Counter
from statistics import median
from typing import Any

from .figures import CLAIMS, GROWTHS, PLAIN, Ratio, curve, ratios, slope

SOLVER_STAGES = {  # stage: heading
    "cold solve": "order, factor, solve",
    "arrays to field": "arrays to field",
    "later factor": "later factor",
    "values": "values only",
    "stroke": "stroke",
    "dab": "dab",
    "16 columns": "16 columns",
}
LINE_STAGES = {"connectivity": "connectivity", "13 isolines": "13 isolines", "100 isolines": "100 isolines"}
SOLVER_FACTS = ("memory", "memory with strokes", "residual", "error")
GROWTH_FROM = 100_000


def write(data: dict[str, Any]) -> str:
    machine = data["machine"]
    head = [
        "# Ours beside other libraries",
        "{processor}, {cores} cores, {memory_gb} GB, {system}; load {load_before:.1f} before the run.".format(
            **machine
        ),
        f"Commit {machine['commit']}, {machine['date']}. Medians, lowest and highest in brackets.",
        *([BUSY] if machine["load_before"] > machine["cores"] else []),
        "## Ours as a share of the best peer",
        summary_table(data["scenes"]),
        "Ours with all cores, against the best of the peers with one or with all. In brackets the project's own"
        " targets, for its reference machine.",
        claims_table(data["scenes"]),
        "Times in milliseconds, memory in MB.",
    ]
    scenes = [part for scene in data["scenes"] for part in describe(scene)]
    growth = growth_table(data["scenes"])
    tail = ["## Growth", GROWTH_NOTE, growth] if growth else []
    return "\n\n".join([*head, *scenes, *tail, NOTES]) + "\n"


BUSY = "**The machine was busy: these times are not to be trusted.**"
GROWTH_NOTE = """Ours with all cores, on the meshes that differ in size alone: time ~ n^p, fitted; by which factor it
grows from the smallest to the largest of them, and by which it may: n log n, or n^1.5 for what factors (a stroke does,
in part)."""

NOTES = """## What is compared

- Graph Laplacian, six discs of 0.5 % of the vertices painted 0 to 1; a stroke adds 0.1 % of the vertices, a dab 30.
  *cotangent*: cotangent weights as they come, negative ones too, for who takes a matrix.
- *ours* is `HarmonicSolver`, which takes a mesh; *ours matrix* is the C++ solver below it, which takes any symmetric
  matrix, on the same course as the direct peers. Multigrid takes one column after the other: no 16.
- *Order, factor, solve*: everybody's matrix is ready-made, of the free vertices alone but for `HarmonicSolver`.
- *Later*, *values*, *stroke*, *dab*: peers keep their analysis too, painted vertices being identity rows of the mesh's
  pattern; a stroke is their factor and solve. Ours is `HarmonicSolver.paint`, checks of its arguments included;
  its later factor leaves out the search for regions, which goes on beside and counts in strokes.
- *Arrays to field*: from positions and faces, connectivity and assembly included. libigl has cotangent weights.
- pyamg solves to a relative residual of 1e-8. Isolines: VTK joins segments to lines as ours does, libigl does not;
  potpourri3d takes a level at a time. Lengths agree when all did the same work.
- Memory: highest of the process over what it held before. The matrix counts: the direct peers' painted one (its lower
  triangle), and ours, which `HarmonicSolver` makes of the mesh.
- Error: the largest, against a reference refined with residuals in extended precision.
- CHOLMOD: supernodal, Debian's, OpenBLAS told its processor. Waiting threads sleep rather than spin."""


def table(rows: list[list[str]]) -> str:
    """The first row is the head; the first column is text, the others are figures."""
    lines = [f"| {' | '.join(row)} |" for row in rows]
    return "\n".join([lines[0], "| --- |" + " ---: |" * (len(rows[0]) - 1), *lines[1:]])


def short(value: float) -> str:
    """Three digits that count."""
    return f"{value:.2e}" if 0 < value < 1e-3 else f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def shown_time(runs: list[float] | None) -> str:
    if not runs:
        return "–"
    middle, low, high = (short(1000 * value) for value in (median(runs), min(runs), max(runs)))
    return f"{middle} [{low}, {high}]"


def summary_table(scenes: list[dict[str, Any]]) -> str:
    """A line for each claim, a column for each mesh."""
    names = [scene["scene"] for scene in scenes]
    rows = [["ours / best peer", *names]]
    for claim in CLAIMS:
        found = {ratio.scene: ratio for ratio in ratios(claim, scenes)}
        if found:
            versus = "any direct solver" if len(claim.peers) > 1 else claim.peers[0]
            rows.append([f"{claim.what} / {versus}", *(share(found.get(name)) for name in names)])
    return table(rows)


def share(ratio: Ratio | None) -> str:
    if ratio is None:
        return "–"
    return f"{ratio.quotient:.2g}" + ("" if ratio.target is None else f" (≤ {ratio.target:.2g})")


def claims_table(scenes: list[dict[str, Any]]) -> str:
    rows = [["what", "mesh", "ours", "peer", "best peer", "ratio", "target", "reached"]]
    said = set()
    for claim in CLAIMS:
        scale = 1 if claim.stage.startswith("memory") else 1000
        for ratio in ratios(claim, scenes):
            if (claim.what, ratio.scene, ratio.title) in said:  # the best of these peers was so of fewer
                continue
            said.add((claim.what, ratio.scene, ratio.title))
            goal = ["", ""]
            if ratio.target is not None:
                goal = [f"≤ {ratio.target:.2g}", "yes" if ratio.quotient <= ratio.target else "no"]
            sides = [short(scale * ratio.ours), short(scale * ratio.peer)]
            rows.append([claim.what, ratio.scene, *sides, ratio.title, f"{ratio.quotient:.2g}", *goal])
    return table(rows)


def describe(scene: dict[str, Any]) -> list[str]:
    """All that was measured on one mesh."""
    if "vertices" not in scene:
        return [f"## {scene['scene']}", f"Not measured: {scene['trouble']}."]
    title = "## {scene}: {vertices:,} vertices, {faces:,} faces, {painted:,} painted".format(**scene)
    effort = (
        "At commit {commit}, {date}, load {load_before:.1f}; up to {runs} runs, none begun after {seconds:g} s of a"
        " stage; stopped after {limit:g} s.".format(**scene, **scene["effort"])
    )
    results = scene["results"]
    trouble = [f"- {result['title']}: {result['trouble']}" for result in results if result["trouble"]]
    parts = [solver_table(results), lines_table(results), strokes_said(results)]
    if trouble:
        parts.append("Not or not wholly measured:\n\n" + "\n".join(trouble))
    return [title, effort, *(part for part in parts if part)]


def solver_table(results: list[dict[str, Any]]) -> str:
    rows = [["ms", *SOLVER_STAGES.values(), "first, user time", "MB", "MB with strokes", "residual", "error"]]
    for result in results:
        if any(stage in result["wall"] for stage in SOLVER_STAGES):
            cells = [shown_time(result["wall"].get(stage)) for stage in SOLVER_STAGES]
            user = result["user"].get("cold solve") or result["user"].get("arrays to field")
            facts = [short(result["facts"][fact]) if fact in result["facts"] else "–" for fact in SOLVER_FACTS]
            rows.append([result["title"], *cells, shown_time(user), *facts])
    return table(rows) if len(rows) > 1 else ""


def lines_table(results: list[dict[str, Any]]) -> str:
    rows = [["ms", *LINE_STAGES.values(), "length of 13", "length of 100"]]
    for result in results:
        if any(stage in result["wall"] for stage in LINE_STAGES):
            lengths = [result["facts"].get(f"length of {count}") for count in (13, 100)]
            shown = ["–" if length is None else f"{length:.8g}" for length in lengths]
            rows.append([result["title"], *(shown_time(result["wall"].get(stage)) for stage in LINE_STAGES), *shown])
    return table(rows) if len(rows) > 1 else ""


def strokes_said(results: list[dict[str, Any]]) -> str:
    """What our solver did at paintings, strokes and dabs."""
    lines = []
    for result in results:
        for kind in ("later", "stroke", "dab"):
            if updates := result["facts"].get(f"{kind} update"):
                did = ", ".join(f"{count} × {update}" for update, count in Counter(updates).items())
                share = median(result["facts"][f"{kind} repeated"])
                lines.append(f"- {result['title']}, {kind}: {did}; {share:.0%} of the factor's work repeated (median)")
    return "\n".join(lines)


def growth_table(scenes: list[dict[str, Any]]) -> str:
    """A line for each stage of ours, a column for each size; and whether it grows no faster than it may."""
    large = [scene for scene in scenes if scene["scene"] in PLAIN and scene.get("vertices", 0) > GROWTH_FROM]
    rows = [["ms", *(scene["scene"] for scene in large), "p", "grows by", "may by", "law", "kept"]]
    for growth in GROWTHS:
        title = next((r["title"] for s in large for r in s["results"] if r["title"].startswith(growth.ours)), "")
        points = dict(curve(large, title, growth.stage))
        if len(points) > 1:
            times = (points.get(scene["vertices"]) for scene in large)
            low, high = min(points), max(points)
            by, may = points[high] / points[low], growth.allowed(low, high)
            verdict = ["n^1.5" if growth.factors else "n log n", "yes" if by <= may else "no"]
            sizes = ["–" if time is None else short(1000 * time) for time in times]
            rows.append(
                [growth.what, *sizes, f"{slope(list(points.items())):.2f}", f"{by:.3g}", f"{may:.3g}", *verdict]
            )
    return table(rows) if len(rows) > 1 else ""
