# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's figures for mesh files, painted with discs that place themselves.

blender --background --factory-startup --python-exit-code 1 --python blender_scripts/figures.py -- MESH…
    [--output FOLDER] [--up x|y|z] [--turn DEGREES] [--window LO HI] [--isolines N] [--width PIXELS]
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from addon_loader import part, run_with_addon, script_words
from figure import Plan, make_figure
from figure_views import UPRIGHT, best_view, other_side
from mathutils import Matrix
from mesh_object import add_mesh_object
from painting_discs import far_apart_discs

_FOLDER = Path(__file__).resolve().parents[1] / "build/figures"
_MOST_SEEN = (0.3, 0.7)  # the window is what lies between these quantiles of the field


def main(addon: ModuleType) -> None:
    library = part(addon, "library")
    args = parse(library.load("command_line"))
    meshes = [library.load().read_mesh(path) for path in args.meshes]  # all of them, before the first is rendered
    args.output.mkdir(parents=True, exist_ok=True)
    for path, mesh in zip(args.meshes, meshes):
        up = args.up or ("z" if path.suffix.lower() == ".stl" else "y")  # as is the custom of scans and of printers
        obj, discs = add_painted(addon, mesh, path.stem, up)
        part(addon, "blender.pipeline").solve_field(obj)
        target = args.output / f"{path.stem}.png"
        library.load("output").write_all([(target, make_figure(addon, obj, plan(addon, obj, discs, args)).save)])
        print(f"wrote {target}")


def parse(command_line: ModuleType) -> argparse.Namespace:
    parser = command_line.OneSentenceParser(prog="figures", description=__doc__.splitlines()[0])
    parser.add_argument("meshes", nargs="+", type=Path, metavar="MESH", help=".obj .ply .off .stl")
    parser.add_argument("--output", type=Path, default=_FOLDER, help="where to write (default: build/figures)")
    parser.add_argument("--up", choices=UPRIGHT, help="axis of the file that points up (default: z in STL, else y)")
    parser.add_argument("--turn", type=float, default=0, help="degrees to walk on from the view chosen")
    parser.add_argument("--window", type=float, nargs=2, metavar=("LO", "HI"), help="of values, for the second row")
    parser.add_argument("--isolines", type=int, default=Plan.levels, metavar="N", help="in either row")
    parser.add_argument("--width", type=int, default=Plan.width, help="of one of the six tiles, in pixels")
    return parser.parse_args(command_line.shield_numbers(script_words()))


def add_painted(addon: ModuleType, mesh, name: str, up: str) -> tuple[bpy.types.Object, np.ndarray]:
    """The mesh as an object that stands upright, with six discs at evenly spread values; and the discs' vertices."""
    obj = add_mesh_object(mesh, name)
    obj.matrix_world = Matrix(UPRIGHT[up]).to_4x4()
    discs = far_apart_discs(mesh)
    for number, disc in enumerate(discs, start=1):
        group = part(addon, "blender.mesh.groups").add_group(obj, f"disc {number}", disc)
        bpy.ops.dirichlet.patch_add_group(group=group)
    bpy.ops.dirichlet.patch_spread_values()
    obj.dirichlet.overlap = "first"  # discs meet on meshes of a few vertices
    return obj, np.concatenate(discs)


def plan(addon: ModuleType, obj: bpy.types.Object, painted: np.ndarray, args: argparse.Namespace) -> Plan:
    upright = np.array(obj.matrix_world.to_3x3())
    view = best_view(part(addon, "blender.mesh.meshes").read_positions(obj.data) @ upright.T, painted)
    view = replace(view, azimuth=view.azimuth + args.turn)
    field = part(addon, "blender.mesh.attributes").read_field(obj.data)
    window = args.window or rounded(*np.nanquantile(field, _MOST_SEEN).tolist())
    size = {"width": args.width, "height": args.width * Plan.height // Plan.width}
    return Plan(view, other_side(view), tuple(window), levels=args.isolines, **size)


def rounded(low: float, high: float) -> tuple[float, float]:
    """Both to two digits, where that keeps them apart."""
    short = round(low, 2), round(high, 2)
    return short if short[0] < short[1] else (low, high)


if __name__ == "__main__":
    sys.exit(run_with_addon("figures", main))
