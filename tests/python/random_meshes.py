# SPDX-License-Identifier: GPL-3.0-or-later
"""Hypothesis strategies: damaged polygon grids, trees of tetrahedra, and paint on them."""

from __future__ import annotations

import damage
import numpy as np
from hypothesis import note
from hypothesis import strategies as st
from mesh_makers import ZOO, Soup

CELLS = ("quad", "two triangles", "other diagonal", "hole", "flipped", "with the next", "twice")


@st.composite
def polygon_grids(draw) -> Soup:
    """Every cell of a bumpy grid kept, split, flipped, doubled, joined with its neighbour or left out."""
    nx, ny = draw(st.integers(1, 6)), draw(st.integers(1, 5))
    kinds = draw(st.lists(st.sampled_from(CELLS), min_size=nx * ny, max_size=nx * ny))
    faces: list[list[int]] = []
    up, joined = nx + 1, False
    for cell, kind in enumerate(kinds):
        a = cell // nx * up + cell % nx
        if joined:
            joined = False
        elif kind == "with the next" and cell % nx < nx - 1:
            faces.append([a, a + 1, a + 2, a + 2 + up, a + 1 + up, a + up])
            joined = True
        else:
            faces += cut([a, a + 1, a + 1 + up, a + up], kind)
    j, i = np.divmod(np.arange((nx + 1) * (ny + 1)), up)
    heights = np.random.default_rng(draw(st.integers(0, 9))).normal(scale=0.2, size=len(i))
    return Soup(np.column_stack((i, j, heights)), faces or [[0, 1, up]])


def cut(quad: list[int], kind: str) -> list[list[int]]:
    a, b, c, d = quad
    return {
        "two triangles": [[a, b, c], [a, c, d]],
        "other diagonal": [[b, c, d], [b, d, a]],
        "hole": [],
        "flipped": [quad[::-1]],
        "twice": [quad, quad[1:] + quad[:1]],
    }.get(kind, [quad])


@st.composite
def tetrahedron_trees(draw) -> Soup:
    """Tetrahedra glued face to face: a closed surface, or with the glued faces kept, a non-manifold complex."""
    glue = draw(st.lists(st.integers(0, 10**6), max_size=12))
    keep = draw(st.booleans())
    outer, inner = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], []
    for apex, choice in enumerate(glue, start=4):
        a, b, c = outer.pop(choice % len(outer))
        inner.append([a, b, c])
        outer += [[a, b, apex], [b, c, apex], [c, a, apex]]
    positions = np.random.default_rng(draw(st.integers(0, 9))).normal(size=(4 + len(glue), 3))
    return Soup(positions, outer + inner if keep else outer)


@st.composite
def damaged_meshes(draw) -> Soup:
    """Up to six damages on a mesh, of the zoo or a random one."""
    soup = draw(st.one_of(st.sampled_from(list(ZOO.values())), polygon_grids(), tetrahedron_trees()))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    kinds = draw(st.lists(st.sampled_from(sorted(damage.KINDS)), min_size=1, max_size=6))
    note(" + ".join(kinds))
    for name in kinds:
        soup = damage.KINDS[name](soup, random)
    return soup


meshes = st.one_of(polygon_grids(), tetrahedron_trees())
values = st.one_of(st.floats(-10, 10), st.sampled_from([0.0, 1.0, -1.0, 1e300, -1e300, 5e-324, np.nextafter(1.0, 2.0)]))


@st.composite
def problems(draw, soups=meshes) -> tuple[Soup, np.ndarray, np.ndarray]:
    """A mesh, distinct painted vertices and their values."""
    soup = draw(soups)
    vertices = draw(st.lists(st.integers(0, soup.size - 1), min_size=1, max_size=min(10, soup.size), unique=True))
    return soup, np.array(vertices), np.array(draw(st.lists(values, min_size=len(vertices), max_size=len(vertices))))
