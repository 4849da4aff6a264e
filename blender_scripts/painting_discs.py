# SPDX-License-Identifier: GPL-3.0-or-later
"""Painted discs placed by themselves: far apart on the surface, connected, round."""

from __future__ import annotations

from collections.abc import Sequence
from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Indices = NDArray[np.int32]
Reals = NDArray[np.float64]


class Neighbours(NamedTuple):
    """Vertex v has the neighbours ids[starts[v]:starts[v + 1]]."""

    starts: NDArray[np.int64]
    ids: Indices


def far_apart_discs(mesh, count: int = 6, share: float = 0.005) -> list[Indices]:
    """`count` discs of share · V vertices each, on the largest piece of a dirichlet_surface.Mesh; the same every time.

    Centres are farthest points by numbers of edges. Cost: O(count · (V + E)) and the sorting of the edges.
    """
    near = neighbours(mesh)
    size = max(1, round(share * mesh.vertex_count))
    return [grow_disc(near, mesh.positions, centre, size) for centre in far_apart_vertices(mesh, near, count)]


def spread_values(discs: Sequence[Indices]) -> tuple[Indices, Reals]:
    """Vertices (C,) and values (C,) of discs that take evenly spread values from 0 to 1; the first one keeps a vertex
    of several."""
    values = np.repeat(np.linspace(0.0, 1.0, len(discs)), [len(disc) for disc in discs])
    vertices, first = np.unique(np.concatenate(discs), return_index=True)
    return vertices, values[first]


def neighbours(mesh) -> Neighbours:
    ends = np.concatenate((mesh.edges, mesh.edges[:, ::-1]))
    ends = ends[np.argsort(ends[:, 0], kind="stable")]
    return Neighbours(np.searchsorted(ends[:, 0], np.arange(mesh.vertex_count + 1)), ends[:, 1])


def far_apart_vertices(mesh, near: Neighbours, count: int) -> list[int]:
    """Farthest-point sampling; begins at the vertex farthest from the first one of the largest piece."""
    labels, pieces = mesh.components()
    inside = labels == int(np.bincount(labels, minlength=pieces).argmax())
    closest = np.where(inside, edge_distance(near, int(np.argmax(inside))), -1)
    chosen = [int(np.argmax(closest))]
    closest = edge_distance(near, chosen[0])
    while len(chosen) < count:
        chosen.append(int(np.argmax(closest)))
        closest = np.minimum(closest, edge_distance(near, chosen[-1]))  # other pieces stay at -1
    return chosen


def edge_distance(near: Neighbours, source: int) -> Indices:
    """(V,) numbers of edges from the source, breadth first; -1 where there is no path."""
    distance = np.full(len(near.starts) - 1, -1, np.int32)
    distance[source] = 0
    front, hops = np.array([source]), 0
    while front.size:
        hops += 1
        first, degree = near.starts[front], near.starts[front + 1] - near.starts[front]
        places = np.repeat(first - np.cumsum(degree) + degree, degree) + np.arange(degree.sum())
        reached = near.ids[places]
        front = np.unique(reached[distance[reached] < 0])
        distance[front] = hops
    return distance


def grow_disc(near: Neighbours, positions: Reals, centre: int, size: int) -> Indices:
    """`size` vertices around the centre, ascending: always the neighbour next nearest to it as the crow flies; fewer
    where the piece is smaller."""
    done: set[int] = set()
    met = {centre}
    queue = [(0.0, centre)]
    while queue and len(done) < size:
        _, vertex = heappop(queue)
        done.add(vertex)
        for other in near.ids[near.starts[vertex] : near.starts[vertex + 1]].tolist():
            if other not in met:
                met.add(other)
                heappush(queue, (float(np.linalg.norm(positions[other] - positions[centre])), other))
    return np.array(sorted(done), np.int32)
