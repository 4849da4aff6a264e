# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK: contour filter, then stripper, which joins the segments to polylines."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkStripper

from ..recorder import Recorder
from ..scene import Scene
from .isoline_levels import Reals, time_levels


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    surface = surface_of(scene)

    def extract(levels: Reals) -> Callable[[], float]:
        contour = vtkContourFilter()
        contour.SetInputData(surface)
        contour.ComputeNormalsOff()
        contour.ComputeScalarsOff()
        for i, level in enumerate(levels):
            contour.SetValue(i, level)
        stripper = vtkStripper()
        stripper.SetMaximumLength(len(scene.positions))
        stripper.SetInputConnection(contour.GetOutputPort())
        stripper.Update()
        lines = stripper.GetOutput()
        return lambda: length(lines)

    time_levels(recorder, extract)


def surface_of(scene: Scene) -> vtkPolyData:
    points = vtkPoints()
    points.SetData(numpy_to_vtk(scene.positions, deep=True))
    cells = vtkCellArray()
    offsets = np.arange(0, scene.faces.size + 1, 3, dtype=np.int64)
    corners = scene.faces.ravel().astype(np.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True))
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(cells)
    result.GetPointData().SetScalars(numpy_to_vtk(scene.reference, deep=True))
    return result


def length(lines: vtkPolyData) -> float:
    points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    corners = points[vtk_to_numpy(lines.GetLines().GetConnectivityArray())]
    steps = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    steps[offsets[1:-1] - 1] = 0  # from one line to the next
    return float(steps.sum())
