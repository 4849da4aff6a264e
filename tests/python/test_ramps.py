# SPDX-License-Identifier: GPL-3.0-or-later
"""Colour ramps: what Blender's ColorRamp would show, in files too."""

import numpy as np
import pytest
from dirichlet_surface.ramps import RAMPS, UNDEFINED_COLOR, apply_ramp, srgb_bytes
from numpy.testing import assert_allclose, assert_array_equal

every_ramp = pytest.mark.parametrize("name", RAMPS)


@every_ramp
def test_stops_are_colours_at_ascending_places_from_0_to_1(name):
    places, colors = map(np.array, zip(*RAMPS[name]))
    assert places[0] == 0
    assert places[-1] == 1
    assert (np.diff(places) > 0).all()
    assert colors.min() >= 0
    assert colors.max() <= 1


@every_ramp
def test_a_value_at_a_stop_has_its_colour_and_between_stops_the_mixture(name):
    places, colors = map(np.array, zip(*RAMPS[name]))
    assert_allclose(apply_ramp(10 + 5 * places, 10, 15, name), colors, atol=1e-12)
    middle = (places[:-1] + places[1:]) / 2
    assert_allclose(apply_ramp(middle, 0, 1, name), (colors[:-1] + colors[1:]) / 2, atol=1e-12)


@every_ramp
def test_colours_stop_at_the_ends_and_nan_is_neutral(name):
    colors = apply_ramp(np.array([-7.0, 9.0, np.nan]), 0, 1, name)
    assert_array_equal(colors, [RAMPS[name][0][1], RAMPS[name][-1][1], UNDEFINED_COLOR])


@pytest.mark.parametrize("name", ["viridis", "grey"])
def test_brightness_only_rises(name):
    luminance = apply_ramp(np.linspace(0, 1, 100), 0, 1, name) @ [0.2126, 0.7152, 0.0722]
    assert (np.diff(luminance) > 0).all()


@every_ramp
def test_a_range_without_width_is_mid_ramp(name):
    assert_array_equal(apply_ramp(np.array([1.0, 2.0]), 2, 2, name), apply_ramp(np.array([0.5, 0.5]), 0, 1, name))


def test_any_range_gives_finite_colours():
    for low, high in [(-1.7e308, 1.7e308), (0, 5e-324), (2, 2), (1, np.nextafter(1, 2))]:
        colors = apply_ramp(np.array([low, high, np.nan]), low, high)
        assert np.isfinite(colors).all()
        assert (low == high) == (colors[0] == colors[1]).all()


def test_srgb_bytes_follow_the_standard_curve():
    assert_array_equal(srgb_bytes(np.array([0.0, 0.001, 0.21586, 1.0, 1.5])), [0, 3, 128, 255, 255])
