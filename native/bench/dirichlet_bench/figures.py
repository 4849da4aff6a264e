# SPDX-License-Identifier: GPL-3.0-or-later
"""What the measurements say: medians, the best peer, ratios, growth. `data` is what report.json holds."""

from collections.abc import Iterator
from math import log
from statistics import linear_regression, median
from typing import Any, NamedTuple

OURS = ("ours, ", "ours matrix")
"""the second where the matrix is not the mesh's graph Laplacian"""
OUR_LINES = ("ours lines",)
DIRECT = ("CHOLMOD", "PARDISO", "Eigen")
PLAIN = ("14k", "125k", "1M", "2M", "4M", "10M")
"""scenes that differ in nothing but size"""


class Claim(NamedTuple):
    """What has to be faster than the best of which peers, by how much on which scene."""

    what: str
    ours: tuple[str, ...]
    stage: str
    peers: tuple[str, ...]
    targets: dict[str, float]


CLAIMS = (
    Claim("arrays in, field out", OURS, "arrays to field", ("libigl",), {"14k": 0.45, "125k": 0.25, "1M": 0.15}),
    Claim("order, factor and solve", OURS, "cold solve", DIRECT, {"14k": 0.6, "125k": 0.5, "1M": 0.45}),
    Claim("later factor", OURS, "later factor", ("CHOLMOD",), {"14k": 0.2, "125k": 0.3, "1M": 0.25}),
    Claim("stroke and solve", OURS, "stroke", ("CHOLMOD",), {"14k": 0.08, "125k": 0.1, "1M": 0.12}),
    Claim("dab and solve", OURS, "dab", ("CHOLMOD",), {}),
    Claim("values only", OURS, "values", ("CHOLMOD",), {"14k": 0.75, "125k": 0.6, "1M": 0.5}),
    Claim("later factor", OURS, "later factor", DIRECT, {}),
    Claim("stroke and solve", OURS, "stroke", DIRECT, {}),
    Claim("values only", OURS, "values", DIRECT, {}),
    Claim("16 right-hand sides", OURS, "16 columns", DIRECT, {}),
    Claim("13 isolines", OUR_LINES, "13 isolines", ("VTK",), {"125k": 1 / 60, "1M": 1 / 60}),
    Claim("100 isolines", OUR_LINES, "100 isolines", ("VTK",), {"125k": 1 / 80, "1M": 1 / 100}),
    Claim("connectivity", OUR_LINES, "connectivity", ("OpenMesh",), {"14k": 1 / 8, "125k": 1 / 8, "1M": 1 / 6}),
    Claim("memory, strokes included", OURS, "memory with strokes", ("CHOLMOD",), {"1M": 1.2}),
    Claim("the same, float32", ("ours float32",), "memory with strokes", ("CHOLMOD",), {"1M": 0.8}),
)


def figure(result: dict[str, Any], stage: str) -> float | None:
    """The median of a stage in seconds, or a fact."""
    runs = result["wall"].get(stage)
    fact: float | None = result["facts"].get(stage)
    if stage == "memory with strokes" and not result["title"].startswith("ours"):
        fact = result["facts"].get("memory")  # peers keep nothing for strokes
    return median(runs) if runs else fact


def best(scene: dict[str, Any], names: tuple[str, ...], stage: str) -> tuple[float, str] | None:
    """The lowest figure among the contestants whose titles begin so, and its title."""
    found = [
        (value, result["title"])
        for result in scene["results"]
        if result["title"].startswith(names) and (value := figure(result, stage)) is not None
    ]
    return min(found, default=None)


class Ratio(NamedTuple):
    scene: str
    ours: float
    peer: float
    title: str
    target: float | None

    @property
    def quotient(self) -> float:
        return self.ours / self.peer


def ratios(claim: Claim, scenes: list[dict[str, Any]]) -> Iterator[Ratio]:
    """One for every scene where both sides were measured. Ours counts as it comes, with all cores: the first."""
    for scene in scenes:
        own = next((r for r in scene["results"] if r["title"].startswith(claim.ours)), None)
        ours = figure(own, claim.stage) if own else None
        peer = best(scene, claim.peers, claim.stage)
        if ours is not None and peer is not None:
            yield Ratio(scene["scene"], ours, *peer, claim.targets.get(scene["scene"]))


class Growth(NamedTuple):
    """A stage that may grow with the number of vertices as n log n, or as n^1.5 where it factors."""

    what: str
    ours: tuple[str, ...]
    stage: str
    factors: bool = False

    def allowed(self, small: int, large: int) -> float:
        """The factor by which time may grow from so many vertices to so many."""
        return (large / small) ** 1.5 if self.factors else large * log(large) / (small * log(small))


GROWTHS = (
    Growth("connectivity", OUR_LINES, "connectivity"),
    Growth("Laplacian", OURS, "laplacian"),
    Growth("order and symbolic analysis", OURS, "analysis"),
    Growth("injection", OURS, "injection"),
    Growth("factor", OURS, "factorisation", factors=True),
    Growth("first solve", OURS, "solve"),
    Growth("values only", OURS, "values"),
    Growth("16 columns", OURS, "16 columns"),
    Growth("later factor", OURS, "later factor", factors=True),
    Growth("stroke and solve", OURS, "stroke", factors=True),
    Growth("dab and solve", OURS, "dab", factors=True),
    Growth("arrays in, field out", OURS, "arrays to field", factors=True),
    Growth("13 isolines", OUR_LINES, "13 isolines"),
    Growth("100 isolines", OUR_LINES, "100 isolines"),
)


def curve(scenes: list[dict[str, Any]], title: str, stage: str) -> list[tuple[int, float]]:
    """Vertices and seconds, on the scenes that differ in size alone."""
    return [
        (scene["vertices"], value)
        for scene in scenes
        for result in scene["results"]
        if scene["scene"] in PLAIN and result["title"] == title and (value := figure(result, stage)) is not None
    ]


def slope(points: list[tuple[int, float]]) -> float | None:
    """p of time ~ n^p, fitted; from two points on."""
    if len(points) < 2:
        return None
    return linear_regression([log(n) for n, _ in points], [log(seconds) for _, seconds in points]).slope
