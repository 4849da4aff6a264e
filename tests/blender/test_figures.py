# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts that render: what they leave in the open file, and how they choose what to show."""

import importlib
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest
from archives import ROOT
from refusal import data_counts
from scene import painted_grid


@pytest.fixture(autouse=True)
def _scripts(monkeypatch):
    monkeypatch.setattr(sys, "path", [str(ROOT / "blender_scripts"), *sys.path])


def test_a_picture_leaves_nothing_in_the_file(addon, pipeline, tmp_path):
    obj = painted_grid()
    pipeline.solve_field(obj)
    pipeline.make_isolines(obj)
    before = data_counts()
    importlib.import_module("saving").render_object(addon, obj, (24, 20), tmp_path / "out.png")
    assert data_counts() == before
    assert tuple(bpy.data.images.load(str(tmp_path / "out.png")).size) == (24, 20)


def test_legend_of_a_figure_has_the_ramps_colors(addon, pipeline):
    obj = painted_grid()
    pipeline.solve_field(obj)
    legend = importlib.import_module("figure")._legend(addon, obj, (0.25, 0.5))
    assert (legend.low, legend.high, legend.window) == (0.0, 1.0, (0.25, 0.5))
    assert legend.colors.shape == (512, 3)
    assert legend.colors[0].argmax() == 2  # blue
    assert legend.colors[-1].argmax() == 0  # red


def test_a_sheet_that_cannot_be_written_is_an_os_error(tmp_path, monkeypatch):
    sheet = importlib.import_module("figure_sheet").Sheet(16, 16)
    with pytest.raises(FileNotFoundError):
        sheet.save(tmp_path / "missing" / "out.png")
    assert not list(tmp_path.iterdir())
    monkeypatch.setattr(Path, "touch", lambda path: None)  # as if the place were lost after that
    with pytest.raises(OSError, match="Blender could not save"):
        sheet.save(Path("/proc/out.png"))
    assert not bpy.data.images


def test_without_lines_the_close_up_shows_the_middle():
    assert importlib.import_module("figure_views").busiest_spot(np.empty((0, 2)), 3.0) == (0.5, 0.5)


@pytest.mark.parametrize(
    ("ends", "shown"),
    [((0.312, 0.688), (0.31, 0.69)), ((0.3121, 0.3122), (0.3121, 0.3122)), ((3e-4, 7e-4), (3e-4, 7e-4))],
)
def test_a_window_is_rounded_only_where_its_ends_stay_apart(ends, shown):
    assert importlib.import_module("figures").rounded(*ends) == shown
