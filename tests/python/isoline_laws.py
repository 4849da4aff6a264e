# SPDX-License-Identifier: GPL-3.0-or-later
"""What has to be true of any isolines, checked on arrays."""

from __future__ import annotations

import numpy as np
from dirichlet_surface import Isolines, Mesh
from numpy.testing import assert_allclose, assert_array_equal


def assert_sound(mesh: Mesh, values: np.ndarray, lines: Isolines) -> None:
    """Shapes, types, points on their edges at their level, no empty segment, ends only where a line may end."""
    assert_arrays_fit(lines)
    assert_points_lie_on_edges_at_their_level(mesh, values, lines)
    start, end = segments(lines)
    lengths = np.hypot.reduce(lines.points[end] - lines.points[start], axis=1)  # tiny ones do not underflow
    assert (lines.points[start] != lines.points[end]).any(axis=1).all(), "a segment has no length"
    totals = np.bincount(line_of_point(lines)[start], lengths, minlength=len(lines))
    assert_allclose(lines.length, totals, rtol=1e-9)
    assert_ends_are_where_a_line_may_end(mesh, values, lines)


def line_of_point(lines: Isolines) -> np.ndarray:
    return np.repeat(np.arange(len(lines)), np.diff(lines.offsets))


def segments(lines: Isolines) -> tuple[np.ndarray, np.ndarray]:
    """First and second point of every segment, closing ones included."""
    following = np.arange(1, len(lines.points) + 1)
    last = lines.offsets[1:] - 1
    following[last] = np.where(lines.closed, lines.offsets[:-1], -1)
    start = np.flatnonzero(following >= 0)
    return start, following[start]


def assert_arrays_fit(lines: Isolines) -> None:
    point_count, line_count = len(lines.t), len(lines)
    expected = {
        "points": ((point_count, 3), np.float64),
        "edges": ((point_count, 2), np.int32),
        "t": ((point_count,), np.float64),
        "offsets": ((line_count + 1,), np.int32),
        "closed": ((line_count,), np.bool_),
        "level": ((line_count,), np.int32),
        "length": ((line_count,), np.float64),
    }
    assert {name: (getattr(lines, name).shape, getattr(lines, name).dtype) for name in expected} == expected
    assert lines.offsets[0] == 0
    assert lines.offsets[-1] == point_count
    assert (np.diff(lines.offsets) >= 2).all()
    assert (np.diff(lines.level) >= 0).all()
    assert ((lines.level >= 0) & (lines.level < len(lines.levels))).all()


def assert_points_lie_on_edges_at_their_level(mesh: Mesh, values: np.ndarray, lines: Isolines) -> None:
    assert ((lines.t >= 0) & (lines.t <= 1)).all()
    first, second = lines.edges.T
    assert (first < second).all()
    known = edge_keys(mesh.vertex_count, *ring(mesh.triangles))
    assert np.isin(edge_keys(mesh.vertex_count, first, second), known).all()
    between = mesh.positions[first] + lines.t[:, None] * (mesh.positions[second] - mesh.positions[first])
    assert_allclose(lines.points, between, rtol=0, atol=1e-13 * np.abs(mesh.positions).max())
    level = lines.levels[lines.level[line_of_point(lines)]]
    low, high = np.minimum(values[first], values[second]), np.maximum(values[first], values[second])
    assert ((low <= level) & (level <= high)).all()
    reached = values[first] * (1 - lines.t) + values[second] * lines.t
    assert (np.abs(reached - level) <= 2e-15 * np.maximum(np.abs(low), np.abs(high)) + 5e-324).all()


def assert_ends_are_where_a_line_may_end(mesh: Mesh, values: np.ndarray, lines: Isolines) -> None:
    for point in ends_in_the_open(mesh, values, lines)[:1]:
        raise AssertionError(f"a line ends in the open at {point}")


def ends_in_the_open(mesh: Mesh, values: np.ndarray, lines: Isolines) -> np.ndarray:
    """Those not on an edge without exactly two triangles (border, non-manifold), or with one beside NaN."""
    carrying = mesh.triangles[~np.isnan(values[mesh.triangles]).any(axis=1)]
    edges_of_two = [edges_with_two_triangles(triangles, mesh.vertex_count) for triangles in (mesh.triangles, carrying)]
    odd = np.setdiff1d(edge_keys(mesh.vertex_count, *ring(mesh.triangles)), np.intersect1d(*edges_of_two))
    ends = np.concatenate((lines.offsets[:-1][~lines.closed], lines.offsets[1:][~lines.closed] - 1))
    elsewhere = lines.points[ends[~np.isin(edge_keys(mesh.vertex_count, *lines.edges[ends].T), odd)]]
    size = np.abs(mesh.positions).max() or 1.0  # whose squares may be beyond the doubles
    first, second = mesh.positions[odd // mesh.vertex_count] / size, mesh.positions[odd % mesh.vertex_count] / size

    def is_in_the_open(point: np.ndarray) -> bool:  # of points that coincide, one on another edge may have been kept
        return distance_to_segments(point / size, first, second).min(initial=np.inf) > 1e-14

    return elsewhere[[is_in_the_open(point) for point in elsewhere]] if len(elsewhere) else elsewhere


def distance_to_segments(point: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    along = second - first
    squared = (along**2).sum(axis=1)
    place = np.clip(((point - first) * along).sum(axis=1) / np.where(squared > 0, squared, 1), 0, 1)
    return np.linalg.norm(first + place[:, None] * along - point, axis=1)


def ring(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """First and second vertex of the three edges of every triangle."""
    return triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()


def edges_with_two_triangles(triangles: np.ndarray, vertex_count: int) -> np.ndarray:
    keys, count = np.unique(edge_keys(vertex_count, *ring(triangles)), return_counts=True)
    return keys[count == 2]


def edge_keys(vertex_count: int, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """One number per undirected edge."""
    return np.minimum(first, second).astype(np.int64) * vertex_count + np.maximum(first, second)


def assert_same_lines(one: Isolines, other: Isolines) -> None:
    for name in ("points", "edges", "t", "offsets", "closed", "level", "length"):
        assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)
