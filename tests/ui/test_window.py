# SPDX-License-Identifier: GPL-3.0-or-later
"""What only a window shows: each test plays a script of inside/ with a real mouse; pictures in build/ui/<script>."""

from window import run_inside


def test_what_an_artist_paints_is_solved_and_drawn(archive):
    run_inside("painting", archive=archive, limit=600)


def test_discs_are_dragged_onto_the_surface_and_levels_picked_from_it(archive):
    run_inside("adding_discs", archive=archive, limit=300)


def test_large_meshes_are_computed_beside_the_interface(archive):
    run_inside("waiting", archive=archive, limit=300)


def test_escape_ends_whatever_takes_long_on_four_million_vertices(archive):
    run_inside("escaping", archive=archive, limit=600)


def test_random_use_leaves_the_field_that_of_the_paint(archive):
    run_inside("soak", archive=archive, limit=300)


def test_previewed_lines_show_where_they_should(archive):
    run_inside("previewing", archive=archive, limit=300)


def test_windows_come_and_go_and_so_does_the_addon(archive):
    run_inside("windows", archive=archive, limit=300)
