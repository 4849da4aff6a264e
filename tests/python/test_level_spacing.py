# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels chosen by what they do on the surface: strips of equal areas, lines at equal distances."""

from itertools import pairwise

import numpy as np
import pytest
from dirichlet_surface import InputError, Mesh, equal_area_levels, equal_distance_levels, isolines
from mesh_makers import ZOO, Soup, cylinder, grid, joined, renumbered, sphere
from numpy.testing import assert_allclose

BOTH = pytest.mark.parametrize("spread", [equal_area_levels, equal_distance_levels])


def disc(rings: int, sectors: int) -> Soup:
    """Radius 1, flat, its middle the first vertex."""
    angle = 2 * np.pi * np.arange(sectors) / sectors
    circle = np.column_stack((np.cos(angle), np.sin(angle), 0 * angle))
    positions = np.vstack([[[0, 0, 0]], *(circle * (ring + 1) / rings for ring in range(rings))])
    faces = [[0, 1 + k, 1 + (k + 1) % sectors] for k in range(sectors)]
    for ring in range(rings - 1):
        for k in range(sectors):
            a, b = 1 + ring * sectors + k, 1 + ring * sectors + (k + 1) % sectors
            faces += [[a, a + sectors, b + sectors], [a, b + sectors, b]]
    return Soup(positions, faces)


def area_below(soup: Soup, field, level: float) -> float:
    """Of the part of the surface where the field is lower, triangle by triangle."""
    total = 0.0
    for triangle in np.asarray(soup.mesh().triangles):
        corners, values = soup.positions[triangle], field[triangle]
        if np.isnan(values).any() or np.ptp(values) == 0:
            continue
        inside = []
        for i in range(3):
            j = (i + 1) % 3
            if values[i] < level:
                inside.append(corners[i])
            if (values[i] < level) != (values[j] < level):
                inside.append(corners[i] + (level - values[i]) / (values[j] - values[i]) * (corners[j] - corners[i]))
        fan = [np.cross(b - inside[0], c - inside[0]) for b, c in pairwise(inside[1:])]
        total += np.linalg.norm(np.sum(fan, axis=0)) / 2 if fan else 0
    return total


@BOTH
@pytest.mark.parametrize("count", [1, 4, 25])
@pytest.mark.parametrize("triangles", [True, False])
def test_a_linear_field_on_a_rectangle_has_even_levels(spread, count, triangles):
    soup = grid(7, 5, triangles)
    field = soup.positions[:, 0]
    assert_allclose(spread(soup.mesh(), field, count), 7 * np.arange(1, count + 1) / (count + 1), atol=1e-9)
    inside = spread(soup.mesh(), field, count, low=1.25, high=6.5)
    assert_allclose(inside, 1.25 + 5.25 * np.arange(1, count + 1) / (count + 1), atol=1e-9)


def test_the_radius_has_levels_at_square_roots_for_areas_and_even_ones_for_distances():
    soup = disc(40, 60)
    radius = np.linalg.norm(soup.positions, axis=1)
    share = np.arange(1, 10) / 10
    assert_allclose(equal_area_levels(soup.mesh(), radius, 9), np.sqrt(share), atol=1e-9)
    assert_allclose(equal_distance_levels(soup.mesh(), radius, 9), share, atol=1e-4)
    cone = soup._replace(positions=soup.positions + np.outer(radius, [0, 0, 2]))
    assert_allclose(equal_area_levels(cone.mesh(), radius, 9), np.sqrt(share), atol=1e-9)
    assert_allclose(equal_distance_levels(cone.mesh(), radius, 9), share, atol=1e-4)


@pytest.mark.parametrize("power", [0.5, 2, 3])
def test_any_function_of_the_radius_has_even_circles(power):
    soup = disc(120, 60)
    radius = np.linalg.norm(soup.positions, axis=1)
    share = np.arange(1, 10) / 10
    assert_allclose(equal_distance_levels(soup.mesh(), radius**power, 9) ** (1 / power), share, atol=3e-3)
    assert_allclose(equal_area_levels(soup.mesh(), radius**power, 9) ** (1 / power), np.sqrt(share), atol=3e-3)


def test_heights_on_a_sphere_are_even_for_areas_and_cosines_for_distances():
    soup = sphere(127, 128)
    height = soup.positions[:, 2]
    assert_allclose(equal_area_levels(soup.mesh(), height, 7), np.arange(-3, 4) / 4, atol=1e-3)
    assert_allclose(equal_distance_levels(soup.mesh(), height, 7), -np.cos(np.pi * np.arange(1, 8) / 8), atol=1e-3)


@pytest.mark.parametrize("name", ZOO)
def test_strips_have_equal_areas_on_every_surface(name):
    soup = ZOO[name]
    field = np.random.default_rng(2).normal(size=soup.size)
    whole = area_below(soup, field, np.inf)
    levels = equal_area_levels(soup.mesh(), field, 6)
    assert (np.diff(levels) > 0).all()
    areas = [area_below(soup, field, level) for level in levels]
    assert_allclose(areas, whole * np.arange(1, 7) / 7, atol=1e-9 * whole)


@BOTH
@pytest.mark.parametrize("name", ["triangle grid", "sphere", "torus"])
def test_a_field_that_is_bent_upwards_keeps_its_lines(spread, name):
    soup = ZOO[name]
    fine = refined(refined(soup))
    field = fine.positions @ [0.3, 0.2, 0.1] + 3
    levels, bent = spread(fine.mesh(), field, 7), spread(fine.mesh(), field**3, 7)
    assert_allclose(np.cbrt(bent), levels, atol=0.01 * np.ptp(field))


def refined(soup: Soup) -> Soup:
    """Every triangle in four."""
    triangles, vertices = np.array(soup.faces), {}
    positions = list(soup.positions)

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in vertices:
            vertices[key] = len(positions)
            positions.append((soup.positions[a] + soup.positions[b]) / 2)
        return vertices[key]

    faces = []
    for a, b, c in triangles:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        faces += [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    return Soup(np.array(positions), faces)


@BOTH
@pytest.mark.parametrize("name", ZOO)
def test_levels_ascend_inside_the_window_and_give_as_many_levels_of_lines(spread, name):
    soup = ZOO[name]
    field = np.random.default_rng(5).normal(size=soup.size)
    for low, high in ((None, None), (-0.5, None), (None, 0.5), (-0.3, 0.4)):
        levels = spread(soup.mesh(), field, 9, low, high)
        assert levels.shape == (9,)
        assert (np.diff(levels) >= 0).all()
        assert (levels > (field.min() if low is None else low)).all()
        assert (levels < (field.max() if high is None else high)).all()
        assert len(np.unique(isolines(soup.mesh(), field, levels).level)) == len(np.unique(levels))


@BOTH
def test_plateaus_and_what_has_no_value_do_not_count(spread):
    soup = grid(12, 3)
    x = soup.positions[:, 0]
    assert_allclose(spread(soup.mesh(), np.clip(x, 4, 9), 4), [5, 6, 7, 8], atol=1e-9)
    step = np.where(x <= 4, x, np.maximum(x - 4, 4))  # the middle lies flat
    assert_allclose(spread(soup.mesh(), step, 3), [2, 4, 6], atol=1e-9)
    undefined = np.where(x <= 8, x, np.nan)
    assert_allclose(spread(soup.mesh(), undefined, 3), [2, 4, 6], atol=1e-9)


@BOTH
def test_the_scale_of_surface_and_field_has_no_say(spread):
    soup = sphere(15, 20)
    field = soup.positions @ [1.0, 0.2, 0.5]
    expected = spread(soup.mesh(), field, 5)
    for scale in (1e-200, 1e-20, 1e140):
        assert_allclose(spread(Mesh(soup.positions * scale, soup.mesh().triangles), field, 5), expected, atol=1e-9)
    for scale in (1e-300, 1e300, 1.3e308):
        assert_allclose(spread(soup.mesh(), field * scale, 5) / scale, expected, atol=1e-9)


@BOTH
def test_the_order_of_vertices_has_hardly_a_say(spread):
    soup = sphere(15, 20)
    number = np.random.default_rng(0).permutation(soup.size)
    field = soup.positions @ [1.0, 0.2, 0.5]
    other = np.empty_like(field)
    other[number] = field
    assert_allclose(spread(renumbered(soup, number).mesh(), other, 5), spread(soup.mesh(), field, 5), atol=1e-9)


def test_a_gap_between_two_pieces_is_no_hindrance():
    soup = joined(cylinder(8, 4), cylinder(8, 4))
    field = soup.positions[:, 2] + np.where(soup.positions[:, 0] > 5, 1000, 0)
    levels = equal_area_levels(soup.mesh(), field, 3)
    assert_allclose(levels[[0, 2]], [2, 1002], atol=1e-6)
    assert 4 <= levels[1] <= 1000
    assert_allclose(equal_distance_levels(soup.mesh(), field, 3)[[0, 2]], [2, 1002], atol=1e-6)


def test_a_field_of_huge_contrast_is_divided_too():
    soup = grid(40, 2)
    field = 10.0 ** (-7.0 * soup.positions[:, 0])
    levels = equal_area_levels(soup.mesh(), field, 9)
    areas = [area_below(soup, field, level) for level in levels]
    assert_allclose(areas, 8 * np.arange(1, 10), atol=1e-6)


@BOTH
@pytest.mark.parametrize(
    ("field", "window"),
    [
        (np.ones(9), (None, None)),
        (np.full(9, np.nan), (None, None)),
        (np.arange(9.0), (3, 3)),
        (np.arange(9.0), (5, 4)),
        (np.arange(9.0), (8, 20)),
        (np.arange(9.0), (-5, 0)),
        (np.arange(9.0), (9, None)),
        (np.arange(9.0), (None, -1)),
        (np.arange(9.0), (np.nan, 3)),
        (np.arange(9.0), ("0", 3)),
        (np.array([np.inf, *range(8)]), (None, None)),
        (np.arange(8.0), (None, None)),
    ],
)
def test_what_cannot_be_divided_is_refused(spread, field, window):
    with pytest.raises(InputError):
        spread(grid(2, 2).mesh(), field, 3, *window)


@BOTH
@pytest.mark.parametrize("window", [(None, None), (1, 3)])
def test_a_surface_without_area_is_not_divided(spread, window):
    soup = grid(2, 2)
    soup.positions[:, 1] = 0
    with pytest.raises(InputError, match="the surface has no area from "):
        spread(soup.mesh(), np.arange(9.0), 3, *window)


@BOTH
@pytest.mark.parametrize("count", [0, -1, 2.5, 10**7])
def test_a_number_of_levels_that_is_none_is_refused(spread, count):
    with pytest.raises(InputError, match="the number of levels"):
        spread(grid(2, 2).mesh(), np.arange(9.0), count)
