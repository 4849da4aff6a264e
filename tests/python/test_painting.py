# SPDX-License-Identifier: GPL-3.0-or-later
"""Patches combine into one value per painted vertex, or say why not."""

import numpy as np
import pytest
from dirichlet_surface import InputError
from dirichlet_surface.painting import OVERLAP_RULES, Patch, combine_patches
from numpy.testing import assert_array_equal

LEFT = Patch("left", np.array([4, 2, 7]), 0.0)
RIGHT = Patch("right", np.array([9, 7, 2]), np.array([1.0, 3.0, -2.0]))


def refusal(patches, rule="error", vertex_count=10) -> str:
    with pytest.raises(InputError) as caught:
        combine_patches(patches, vertex_count, rule)
    message = str(caught.value)
    assert "\n" not in message
    return message


def test_a_painting_is_sorted_and_unique():
    painting = combine_patches([Patch("a", np.array([8, 1, 8]), 2.0), Patch("b", np.array([0]), np.array([5]))], 10)
    assert_array_equal(painting.vertices, [0, 1, 8])
    assert_array_equal(painting.values, [5, 2, 2])
    assert painting.vertices.dtype == np.int32
    assert painting.values.dtype == np.float64
    assert painting.warnings == ()


def test_a_vertex_with_two_values_names_both_patches():
    assert refusal([LEFT, RIGHT]) == (
        "vertex 2 is in 'left' with value 0 and in 'right' with value -2 (and 1 more vertex)"
        "; an overlap rule decides: first, highest, average"
    )


@pytest.mark.parametrize(("rule", "at_2", "at_7"), [("first", 0, 0), ("highest", 0, 3), ("average", -1, 1.5)])
def test_a_rule_decides_where_patches_overlap(rule, at_2, at_7):
    painting = combine_patches([LEFT, RIGHT], 10, rule)
    assert_array_equal(painting.vertices, [2, 4, 7, 9])
    assert_array_equal(painting.values, [at_2, 0, at_7, 1])


@pytest.mark.parametrize("rule", OVERLAP_RULES)
def test_patches_that_agree_need_no_rule(rule):
    painting = combine_patches([Patch(name, np.array([1, 3]), 0.1) for name in "abcdefg"], 5, rule)
    assert_array_equal(painting.values, [0.1, 0.1])


def test_the_average_of_huge_values_is_finite():
    patches = [Patch(str(value), np.array([0]), value) for value in (1.7e308, 1.6e308, -1.7e308)]
    assert combine_patches(patches, 1, "average").values == pytest.approx([1.6e308 / 3])


def test_values_one_ulp_apart_are_told_apart():
    above = np.nextafter(0.3, 1)
    message = refusal([Patch("a", np.array([0]), 0.3), Patch("b", np.array([0]), above)])
    assert "0.3 " in message
    assert repr(float(above)) in message


@pytest.mark.parametrize("rule", OVERLAP_RULES)
def test_no_rule_covers_one_patch_with_two_values_for_a_vertex(rule):
    patch = Patch("waves", np.array([5, 3, 5, 5]), np.array([1.0, 1.0, 1.0, 2.0]))
    assert refusal([patch, RIGHT], rule) == "vertex 5 is in 'waves' with value 1 and in 'waves' with value 2"


def test_an_empty_patch_among_others_is_a_warning_that_names_it():
    painting = combine_patches([Patch("nobody", np.array([], int), 1.0), LEFT], 10)
    assert len(painting.vertices) == 3
    assert painting.warnings == ("patch 'nobody' has no vertices: left out",)


def test_nothing_painted_is_refused_by_name():
    assert "at least one patch" in refusal([])
    assert refusal([Patch("a", [], 1.0)]) == "nothing is painted: patch 'a' has no vertices"
    many = refusal([Patch(name, [], 1.0) for name in "abcdef"])
    assert many == "nothing is painted: patches 'a', 'b', 'c' and 3 more have no vertices"


@pytest.mark.parametrize("vertex", [-1, 10])
def test_a_vertex_outside_the_mesh_is_named_with_its_patch(vertex):
    message = refusal([Patch("a", np.array([0, vertex, vertex]), 1.0)])
    assert message == f"patch 'a' has the vertex {vertex}, but the vertices are 0 to 9 (and 1 more vertex)"


@pytest.mark.parametrize("vertex", [2**31, 2**32 + 1, 2**63])
def test_a_vertex_beyond_32_bits_does_not_wrap(vertex):
    message = refusal([Patch("a", np.array([0, vertex], np.uint64), 1.0)])
    assert "'a'" in message
    assert str(vertex) in message


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_value_that_is_not_finite_is_named_with_its_vertex(value):
    message = refusal([LEFT, Patch("b", np.array([9, 8]), np.array([1.0, value]))])
    assert "'b'" in message
    assert "vertex 8" in message
    assert str(value) in message
    assert "vertex 9" in refusal([LEFT, Patch("b", np.array([9, 8]), value)])


@pytest.mark.parametrize(
    "patch",
    [
        Patch("odd", np.array([1.0, 2.0]), 1.0),
        Patch("odd", np.array([[1, 2]]), 1.0),
        Patch("odd", np.array([True, False]), 1.0),
        Patch("odd", np.array([1, 2]), np.array([1.0, 2.0, 3.0])),
        Patch("odd", np.array([1, 2]), "high"),
        Patch("odd", np.array([1, 2]), None),
    ],
    ids=["float vertices", "two dimensions", "mask", "too many values", "text", "nothing"],
)
def test_a_patch_of_the_wrong_kind_is_named(patch):
    assert refusal([LEFT, patch]).count("patch 'odd'") == 1


def test_an_unknown_rule_is_refused_with_the_known_ones():
    assert refusal([LEFT], "lowest").endswith("error, first, highest, average")


def test_five_thousand_patches_combine():
    patches = [Patch(f"p{k}", np.array([k, k + 1]), float(k)) for k in range(5000)]
    painting = combine_patches(patches, 5001, "first")
    assert_array_equal(painting.values, np.maximum(np.arange(5001) - 1.0, 0))
