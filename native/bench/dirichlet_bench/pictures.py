# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m dirichlet_bench.pictures report.json: time against size, and the latency of strokes, beside that file."""

import json
import sys
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.ticker import NullLocator

from .figures import PLAIN, curve, slope

PANELS = {
    "cold solve": "Order, factor and solve",
    "arrays to field": "Arrays in, field out",
    "later factor": "Later factor: another painting, same mesh",
    "stroke": "Stroke of 0.1 % of the vertices, and solve",
    "13 isolines": "13 isolines",
    "connectivity": "Connectivity",
}
OURS_COLOR = "#c2185b"
STYLES = {  # beginning of a title: colour, marker
    "ours float32": ("#f48fb1", "D"),
    "ours multigrid": ("#8e24aa", "P"),
    "ours matrix": ("#ad1457", "*"),
    "ours": (OURS_COLOR, "o"),
    "CHOLMOD, AMD": ("#1565c0", "s"),
    "CHOLMOD, METIS": ("#64b5f6", "s"),
    "PARDISO": ("#2e7d32", "^"),
    "Eigen": ("#6d4c41", "v"),
    "pyamg": ("#757575", "P"),
    "libigl": ("#ef6c00", "X"),
    "VTK": ("#00838f", "s"),
    "potpourri3d": ("#9e9d24", "^"),
    "OpenMesh": ("#4527a0", "v"),
}
FRAME = 1 / 60


def style(title: str) -> dict[str, Any]:
    color, marker = next(look for start, look in STYLES.items() if title.startswith(start))
    alone = title.endswith("1 thread") and title.startswith(("ours", "CHOLMOD", "PARDISO"))
    return {"color": color, "marker": marker, "linestyle": ":" if alone else "-", "markersize": 5}


def titles(scenes: list[dict[str, Any]]) -> list[str]:
    return list(dict.fromkeys(result["title"] for scene in scenes for result in scene["results"]))


def draw_growth(scenes: list[dict[str, Any]], path: Path) -> None:
    """Log-log; the exponent of each curve is in the legend."""
    figure, grid = plt.subplots(2, 3, figsize=(17, 13), constrained_layout=True)
    for axes, (stage, heading) in zip(grid.ravel(), PANELS.items()):
        for title in titles(scenes):
            if points := curve(scenes, title, stage):
                p = slope(points)
                label = title if p is None else f"{title}: n^{p:.2f}"
                width = 2.2 if title.startswith("ours") else 1.1
                axes.plot(*zip(*[(n, 1000 * t) for n, t in points]), label=label, linewidth=width, **style(title))
        axes.set(xscale="log", yscale="log", title=heading, xlabel="vertices", ylabel="milliseconds")
        axes.set_xticks([scene["vertices"] for scene in scenes], [scene["scene"] for scene in scenes])
        axes.xaxis.set_minor_locator(NullLocator())
        finish(axes)
        if axes.lines:
            axes.legend(fontsize=9, frameon=False, ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.12))
    figure.savefig(path, dpi=110)


def draw_strokes(scenes: list[dict[str, Any]], path: Path) -> None:
    """Every single stroke."""
    figure, grid = plt.subplots(1, 2, figsize=(15, 6.5), constrained_layout=True, sharey=True)
    for axes, (stage, heading) in zip(grid, (("stroke", PANELS["stroke"]), ("dab", "Dab of 30 vertices, and solve"))):
        names = [title for title in titles(scenes) if any(runs(scene, title, stage) for scene in scenes)]
        for i, title in enumerate(names):
            for j, scene in enumerate(scenes):
                times = [1000 * seconds for seconds in runs(scene, title, stage)]
                place = j + 0.8 * ((i + 0.5) / len(names) - 0.5)
                label = title if j == 0 else None
                axes.scatter([place] * len(times), times, label=label, s=22, alpha=0.8, linewidths=1.2, **dot(title))
        axes.axhline(1000 * FRAME, color="black", linewidth=0.8, linestyle="--")
        axes.text(1.01, 1000 * FRAME, "60 Hz", fontsize=9, va="center", transform=axes.get_yaxis_transform())
        axes.set(yscale="log", title=heading, ylabel="milliseconds, each stroke a dot")
        axes.set_xticks(range(len(scenes)), [scene["scene"] for scene in scenes])
        axes.set_xlim(-0.5, len(scenes) - 0.5)
        finish(axes)
        for j in range(1, len(scenes)):
            axes.axvline(j - 0.5, color="black", linewidth=0.5, alpha=0.3)
    figure.legend(*grid[0].get_legend_handles_labels(), loc="outside lower center", ncols=4, frameon=False)
    figure.savefig(path, dpi=110)


def runs(scene: dict[str, Any], title: str, stage: str) -> list[float]:
    return [seconds for r in scene["results"] if r["title"] == title for seconds in r["wall"].get(stage, [])]


def dot(title: str) -> dict[str, Any]:
    look = style(title)
    return {"color": look["color"], "marker": "x" if look["linestyle"] == ":" else look["marker"]}


def finish(axes: Axes) -> None:
    axes.grid(True, axis="y", alpha=0.3)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def main(file: Path) -> None:
    scenes = [s for s in json.loads(file.read_text(encoding="utf-8"))["scenes"] if s["scene"] in PLAIN]
    if not scenes:
        print("No pictures: they are of the meshes that differ in nothing but size.")
        return
    draw_growth(scenes, file.with_name("time.png"))
    draw_strokes(scenes, file.with_name("strokes.png"))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
