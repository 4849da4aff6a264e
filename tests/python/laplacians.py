# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators as SciPy matrices, and what their tests are made of."""

from __future__ import annotations

import dirichlet_surface as ds
import numpy as np
import scipy.sparse
from mesh_makers import Soup, grid

GEOMETRIC = ("cotangent", "intrinsic_delaunay", "polygon")


def stiffness(soup: Soup, laplacian: str) -> scipy.sparse.csr_matrix:
    csr = ds.stiffness_matrix(soup.mesh(), laplacian)
    return scipy.sparse.csr_matrix((csr.data, csr.indices, csr.indptr), shape=csr.shape)


def mass(soup: Soup, laplacian: str) -> np.ndarray:
    return ds.lumped_mass(soup.mesh(), laplacian)


def half_cotangent(at, one, other) -> float:
    """Of the angle at a corner between two others."""
    u, v = one - at, other - at
    return 0.5 * (u @ v) / np.linalg.norm(np.cross(u, v))


def cotangent_reference(soup: Soup) -> np.ndarray:
    """K of a triangle mesh, dense, triangle by triangle."""
    K = np.zeros((soup.size, soup.size))
    for face in soup.faces:
        for k in range(3):
            i, j, apex = face[k], face[(k + 1) % 3], face[(k + 2) % 3]
            weight = half_cotangent(*soup.positions[[apex, i, j]])
            K[[i, j], [i, j]] += weight
            K[[i, j], [j, i]] -= weight
    return K


def polygon_reference(soup: Soup) -> tuple[np.ndarray, np.ndarray]:
    """K and lumped mass as in Bunge et al. 2020, dense, polygon by polygon, by least squares of all cross products."""
    K, lumped = np.zeros((soup.size, soup.size)), np.zeros(soup.size)
    for face in soup.faces:
        x, size = soup.positions[face], len(face)
        e = np.roll(x, -1, axis=0) - x
        # (x_i − p) × e_i as a linear function of p
        across = np.vstack([[[0, d[2], -d[1]], [-d[2], 0, d[0]], [d[1], -d[0], 0]] for d in e])
        p = np.linalg.lstsq(across, np.cross(x, e).ravel(), rcond=1e-9)[0]
        w = np.linalg.lstsq(np.vstack((x.T, np.ones(size))), np.append(p, 1), rcond=1e-9)[0]
        fine = Soup(np.vstack((x, w @ x)), [[i, (i + 1) % size, size] for i in range(size)])
        P = np.vstack((np.eye(size), w))
        K[np.ix_(face, face)] += P.T @ cotangent_reference(fine) @ P
        areas = np.linalg.norm(np.cross(x - w @ x, e), axis=1) / 2
        lumped[face] += P.T @ np.append((areas + np.roll(areas, 1)) / 3, areas.sum() / 3)
    return K, lumped


def shaken(soup: Soup, amount: float, seed: int = 0) -> Soup:
    """Its vertices moved in the plane z = 0, but for those on the border of the bounding box."""
    x = soup.positions
    inside = ((x[:, :2] > x[:, :2].min(axis=0)) & (x[:, :2] < x[:, :2].max(axis=0))).all(axis=1)
    move = np.random.default_rng(seed).uniform(-amount, amount, x.shape) * [1, 1, 0]
    return Soup(x + move * inside[:, None], soup.faces)


def rotated(soup: Soup) -> Soup:
    """In a plane that is none of the coordinate planes."""
    Q = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]
    return Soup(soup.positions @ Q, soup.faces)


def hexagons(n: int) -> Soup:
    """A plane of bricks, three corners on each long side."""
    faces = []
    for row in range(n):
        start = row % 2
        for k in range(start, 2 * n - 1, 2):
            a, b = row * (2 * n + 1) + k, (row + 1) * (2 * n + 1) + k
            faces.append([a, a + 1, a + 2, b + 2, b + 1, b])
    columns = np.arange((n + 1) * (2 * n + 1))
    return used(
        Soup(np.column_stack((columns % (2 * n + 1), columns // (2 * n + 1), 0 * columns)).astype(float), faces)
    )


def used(soup: Soup) -> Soup:
    """Without vertices that no face names."""
    names = np.unique(np.concatenate(soup.faces))
    number = np.full(soup.size, -1)
    number[names] = np.arange(len(names))
    return Soup(soup.positions[names], [[int(number[v]) for v in face] for face in soup.faces])


def pentagram() -> Soup:
    """A polygon that crosses itself."""
    angle = 4 * np.pi * np.arange(5) / 5
    return Soup(np.column_stack((np.sin(angle), np.cos(angle), 0 * angle)), [list(range(5))])


def border(soup: Soup) -> np.ndarray:
    return np.unique(soup.mesh().border_loops()[1])


def obtuse_strip(n: int) -> Soup:
    """A flat grid whose diagonals are long: plain cotangents leave the painted range on it."""
    soup = grid(n, n)
    return Soup(soup.positions * [1, 1, 0] + soup.positions[:, [1, 0, 2]] * [-4, 0, 0], soup.faces)
