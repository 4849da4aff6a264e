# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes that the Python tests are made of, as faces that are easy to write down and to damage."""

from __future__ import annotations

from typing import NamedTuple

import dirichlet_surface
import numpy as np
import scipy.sparse


class Soup(NamedTuple):
    """positions (V, 3) and faces as lists of vertices."""

    positions: np.ndarray
    faces: list[list[int]]

    def mesh(self) -> dirichlet_surface.Mesh:
        return dirichlet_surface.Mesh(self.positions, polygons(self.faces))

    @property
    def size(self) -> int:
        return len(self.positions)


def polygons(faces) -> tuple[np.ndarray, np.ndarray]:
    """Faces as the (offsets, corners) pair that the library takes."""
    offsets = np.cumsum([0, *map(len, faces)], dtype=np.int32)
    return offsets, np.array([vertex for face in faces for vertex in face], dtype=np.int32)


def adjacency(soup: Soup) -> scipy.sparse.csr_matrix:
    """A of the polygon edges, 0/1, written down anew for comparison."""
    edges = {
        tuple(sorted(edge)) for face in soup.faces for edge in zip(face, face[1:] + face[:1]) if edge[0] != edge[1]
    }
    first, second = np.array(sorted(edges)).T
    ones = np.ones(len(first))
    half = scipy.sparse.coo_matrix((ones, (first, second)), shape=(soup.size, soup.size))
    return scipy.sparse.csr_matrix(half + half.T)


def grid(nx: int, ny: int, triangles: bool = True) -> Soup:
    """(nx + 1) × (ny + 1) vertices at whole places of z = 0; vertex (i, j) is i + j (nx + 1); +z is outside."""
    j, i = np.divmod(np.arange((nx + 1) * (ny + 1)), nx + 1)
    quads = [
        [a, a + 1, a + nx + 2, a + nx + 1] for row in range(ny) for a in range(row * (nx + 1), row * (nx + 1) + nx)
    ]
    return Soup(np.column_stack((i, j, 0 * i)).astype(float), split(quads) if triangles else quads)


def split(quads) -> list[list[int]]:
    """Every quad a b c d as the triangles a b c and a c d."""
    return [triangle for a, b, c, d in quads for triangle in ([a, b, c], [a, c, d])]


def cylinder(around: int, up: int, triangles: bool = True) -> Soup:
    """Radius 1, axis z, rings at the whole heights 0 … up; vertex k of ring j is k + j around; outward."""
    j, k = np.divmod(np.arange(around * (up + 1)), around)
    angle = 2 * np.pi * k / around
    quads = [
        [k + j * around, (k + 1) % around + j * around, (k + 1) % around + (j + 1) * around, k + (j + 1) * around]
        for j in range(up)
        for k in range(around)
    ]
    return Soup(np.column_stack((np.cos(angle), np.sin(angle), j)), split(quads) if triangles else quads)


def torus(nu: int, nv: int, triangles: bool = True, klein: bool = False) -> Soup:
    """nu × nv quads closed in both directions, outward; with `klein`, one seam is glued the wrong way round."""
    v, u = np.divmod(np.arange(nu * nv), nu)
    angle, tilt = 2 * np.pi * u / nu, 2 * np.pi * v / nv
    radius = 2 + 0.7 * np.cos(tilt)
    positions = np.column_stack((radius * np.cos(angle), radius * np.sin(angle), 0.7 * np.sin(tilt)))

    def at(i: int, j: int) -> int:
        if klein and i == nu:
            j = -j
        return i % nu + j % nv * nu

    quads = [[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for j in range(nv) for i in range(nu)]
    return Soup(positions, split(quads) if triangles else quads)


def sphere(rings: int, sectors: int) -> Soup:
    """Radius 1 in triangles and outward: poles first and last, `rings` rings of `sectors` vertices in between."""
    ring, sector = np.divmod(np.arange(rings * sectors), sectors)
    theta, phi = np.pi * (ring + 1) / (rings + 1), 2 * np.pi * sector / sectors
    belt = np.column_stack((np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)))

    def at(ring: int, sector: int) -> int:
        return 1 + ring * sectors + sector % sectors

    faces = []
    for k in range(sectors):
        faces.append([0, at(0, k), at(0, k + 1)])
        faces += split([[at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)] for r in range(rings - 1)])
        faces.append([at(rings - 1, k), 1 + rings * sectors, at(rings - 1, k + 1)])
    return Soup(np.vstack(([0, 0, 1], belt, [0, 0, -1])), faces)


def moebius(n: int) -> Soup:
    """A band of n quads with a half twist."""
    angle = np.repeat(2 * np.pi * np.arange(n) / n, 2)
    side = np.tile([-0.4, 0.4], n)
    radius = 1 + side * np.cos(angle / 2)
    positions = np.column_stack((radius * np.cos(angle), radius * np.sin(angle), side * np.sin(angle / 2)))
    faces = [[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(n - 1)]
    return Soup(positions, [*faces, [2 * n - 2, 1, 0, 2 * n - 1]])


def tetrahedron() -> Soup:
    return Soup(np.vstack((np.zeros(3), np.eye(3))), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def prism(n: int) -> Soup:
    """Two n-gons and n quads."""
    angle = 2 * np.pi * np.arange(2 * n) / n
    positions = np.column_stack((np.cos(angle), np.sin(angle), np.repeat([0.0, 1.0], n)))
    sides = [[k, (k + 1) % n, (k + 1) % n + n, k + n] for k in range(n)]
    return Soup(positions, [list(range(n))[::-1], list(range(n, 2 * n)), *sides])


def book(pages: int) -> Soup:
    """`pages` triangles on one edge: non-manifold from three on."""
    angle = 2 * np.pi * np.arange(pages) / pages
    positions = np.vstack(([0, 0, 0], [0, 0, 1], np.column_stack((np.cos(angle), np.sin(angle), 0 * angle))))
    return Soup(positions, [[0, 1, 2 + page] for page in range(pages)])


def bow_tie() -> Soup:
    """Two triangles that share one vertex."""
    return Soup(np.array([[0, 0, 0], [1, 1, 0], [1, -1, 0], [-1, 1, 0], [-1, -1, 0]], float), [[0, 2, 1], [0, 3, 4]])


def joined(*soups: Soup) -> Soup:
    """Side by side, without a vertex in common."""
    faces, positions = [], []
    for place, soup in enumerate(soups):
        first = sum(map(len, positions))
        faces += [[vertex + first for vertex in face] for face in soup.faces]
        positions.append(soup.positions + np.array([10.0 * place, 0, 0]))
    return Soup(np.vstack(positions), faces)


def renumbered(soup: Soup, new_number: np.ndarray) -> Soup:
    """The same surface with vertex v called new_number[v]."""
    positions = np.empty_like(soup.positions)
    positions[new_number] = soup.positions
    return Soup(positions, [[int(new_number[vertex]) for vertex in face] for face in soup.faces])


#: One of every kind of surface on which the laws have to hold.
ZOO = {
    "triangle grid": grid(7, 5),
    "quad grid": grid(6, 4, triangles=False),
    "quad cylinder": cylinder(8, 5, triangles=False),
    "sphere": sphere(7, 10),
    "torus": torus(12, 7),
    "Klein bottle": torus(12, 7, klein=True),
    "Möbius band": moebius(11),
    "prism": prism(9),
    "tetrahedron": tetrahedron(),
    "book of five pages": book(5),
    "bow tie": bow_tie(),
}
