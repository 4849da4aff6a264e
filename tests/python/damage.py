# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens to meshes before they reach a user: each kind of damage as a function of a soup and a random generator.

Any of them may follow any other; where there is nothing to damage, the soup is given back as it is.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from mesh_makers import Soup, renumbered

Damage = Callable[[Soup, np.random.Generator], Soup]
KINDS: dict[str, Damage] = {}


def kind(damage: Damage) -> Damage:
    KINDS[damage.__name__.replace("_", " ")] = damage
    return damage


def some_face(soup: Soup, random: np.random.Generator) -> int:
    return int(random.integers(len(soup.faces)))


def some_edge(soup: Soup, random: np.random.Generator) -> tuple[int, int]:
    face = soup.faces[some_face(soup, random)]
    corner = int(random.integers(len(face)))
    return face[corner], face[corner - 1]


def with_face(soup: Soup, number: int, *new: list[int]) -> Soup:
    """The face replaced by others."""
    return Soup(soup.positions, [*soup.faces[:number], *new, *soup.faces[number + 1 :]])


def with_vertex(soup: Soup, position: np.ndarray) -> Soup:
    return Soup(np.vstack((soup.positions, position)), soup.faces)


def moved(soup: Soup, vertex: int, position: np.ndarray) -> Soup:
    positions = soup.positions.copy()
    positions[vertex] = position
    return Soup(positions, soup.faces)


@kind
def face_twice(soup: Soup, random: np.random.Generator) -> Soup:
    face = soup.faces[some_face(soup, random)]
    return Soup(soup.positions, [*soup.faces, face[1:] + face[:1]])


@kind
def face_turned_over(soup: Soup, random: np.random.Generator) -> Soup:
    number = some_face(soup, random)
    return with_face(soup, number, soup.faces[number][::-1])


@kind
def face_left_out(soup: Soup, random: np.random.Generator) -> Soup:
    return with_face(soup, some_face(soup, random)) if len(soup.faces) > 1 else soup


@kind
def hole_around_a_vertex(soup: Soup, random: np.random.Generator) -> Soup:
    vertex = int(random.integers(soup.size))
    kept = [face for face in soup.faces if vertex not in face]
    return Soup(soup.positions, kept or soup.faces)


@kind
def two_vertices_merged(soup: Soup, random: np.random.Generator) -> Soup:
    """Anywhere on the surface, as merging by distance does; faces that this leaves without an area go."""
    kept, gone = random.integers(soup.size, size=2)
    faces = [[int(kept) if v == gone else v for v in face] for face in soup.faces]
    faces = [face for face in faces if len(set(face)) == len(face)]
    return Soup(soup.positions, faces or soup.faces)


@kind
def seam(soup: Soup, random: np.random.Generator) -> Soup:
    """A corner with a copy of its vertex."""
    number = some_face(soup, random)
    face = list(soup.faces[number])
    corner = int(random.integers(len(face)))
    soup = with_vertex(soup, soup.positions[face[corner]])
    face[corner] = soup.size - 1
    return with_face(soup, number, face)


@kind
def triangle_soup(soup: Soup, random: np.random.Generator) -> Soup:
    """No two faces with a vertex in common."""
    ends = np.cumsum([0, *map(len, soup.faces)])
    corners = [vertex for face in soup.faces for vertex in face]
    faces = [list(range(begin, end)) for begin, end in pairwise(ends)]
    return Soup(soup.positions[corners], faces)


@kind
def edge_without_length(soup: Soup, random: np.random.Generator) -> Soup:
    vertex, other = some_edge(soup, random)
    return moved(soup, vertex, soup.positions[other])


@kind
def face_without_area(soup: Soup, random: np.random.Generator) -> Soup:
    face = soup.faces[some_face(soup, random)]
    positions = soup.positions.copy()
    ends = positions[face[0]], positions[face[-1]]
    positions[face] = np.linspace(*ends, len(face))
    return Soup(positions, soup.faces)


@kind
def needle(soup: Soup, random: np.random.Generator) -> Soup:
    """A vertex at 1e-4 … 1e-12 of its edge from the other end."""
    vertex, other = some_edge(soup, random)
    share = 10.0 ** random.integers(-12, -3)
    return moved(soup, vertex, soup.positions[other] + share * (soup.positions[vertex] - soup.positions[other]))


@kind
def spike(soup: Soup, random: np.random.Generator) -> Soup:
    vertex = int(random.integers(soup.size))
    size = np.abs(soup.positions).max()
    return moved(soup, vertex, soup.positions[vertex] + random.normal(size=3) * 1e6 * size)


@kind
def huge(soup: Soup, random: np.random.Generator) -> Soup:
    return rescaled(soup, 1e140)


@kind
def tiny(soup: Soup, random: np.random.Generator) -> Soup:
    return rescaled(soup, 1e-150)


def rescaled(soup: Soup, size: float) -> Soup:
    """To a largest coordinate of that size, so that damages on damages stay within the doubles."""
    largest = np.abs(soup.positions).max()
    return Soup(soup.positions / largest * size, soup.faces) if largest > 0 else soup


@kind
def squeezed(soup: Soup, random: np.random.Generator) -> Soup:
    return Soup(soup.positions * random.permutation([1e-6, 1.0, 1.0]), soup.faces)


@kind
def far_from_the_origin(soup: Soup, random: np.random.Generator) -> Soup:
    return Soup(soup.positions + np.abs(soup.positions).max() * 10.0 ** random.integers(3, 13), soup.faces)


@kind
def isolated_vertex(soup: Soup, random: np.random.Generator) -> Soup:
    return with_vertex(soup, random.normal(size=3))


@kind
def fin(soup: Soup, random: np.random.Generator) -> Soup:
    """One face more on an edge."""
    edge = some_edge(soup, random)
    soup = with_vertex(soup, soup.positions[list(edge)].mean(axis=0) + random.normal(size=3))
    return Soup(soup.positions, [*soup.faces, [*edge, soup.size - 1]])


@kind
def bow_tie(soup: Soup, random: np.random.Generator) -> Soup:
    """A triangle that hangs on a vertex alone."""
    vertex, _ = some_edge(soup, random)
    positions = np.vstack((soup.positions, soup.positions[vertex] + random.normal(size=(2, 3))))
    return Soup(positions, [*soup.faces, [vertex, soup.size, soup.size + 1]])


@kind
def concave_polygon(soup: Soup, random: np.random.Generator) -> Soup:
    """A corner pushed to the other side of its neighbours' diagonal."""
    face = soup.faces[some_face(soup, random)]
    corner = int(random.integers(len(face)))
    before, after = soup.positions[face[corner - 1]], soup.positions[face[(corner + 1) % len(face)]]
    middle, opposite = (before + after) / 2, soup.positions[face[(corner + len(face) // 2) % len(face)]]
    return moved(soup, face[corner], middle + 0.3 * (opposite - middle))


@kind
def two_faces_in_one(soup: Soup, random: np.random.Generator) -> Soup:
    """An n-gon: a face together with one beside it, where that gives no vertex twice."""
    number = some_face(soup, random)
    face = soup.faces[number]
    for other, beside in enumerate(soup.faces):
        for a, b in zip(face, face[1:] + face[:1]):
            if other != number and {a, b} == set(face) & set(beside) and (b, a) in zip(beside, beside[1:] + beside[:1]):
                turned = face[face.index(b) :] + face[: face.index(b)]  # b … a
                way = beside[beside.index(a) :] + beside[: beside.index(a)]  # a … b
                faces = [kept for place, kept in enumerate(soup.faces) if place not in (number, other)]
                return Soup(soup.positions, [*faces, turned + way[1:-1]])
    return soup


@kind
def corners_in_another_order(soup: Soup, random: np.random.Generator) -> Soup:
    """A face that may cross itself."""
    number = some_face(soup, random)
    return with_face(soup, number, [int(v) for v in random.permutation(soup.faces[number])])


@kind
def vertices_renumbered(soup: Soup, random: np.random.Generator) -> Soup:
    return renumbered(soup, random.permutation(soup.size))


@kind
def corner_twice(soup: Soup, random: np.random.Generator) -> Soup:
    """In a row, which is legal: the quad a b c c."""
    number = some_face(soup, random)
    face = soup.faces[number]
    return with_face(soup, number, [*face, face[-1]])
