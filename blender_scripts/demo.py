# SPDX-License-Identifier: GPL-3.0-or-later
"""Paints Blender's monkey, solves and draws isolines with the add-on's operators, saves the file and a picture of it.

blender --background --factory-startup --python-exit-code 1 --python blender_scripts/demo.py -- [FOLDER] [--quick]
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from addon_loader import part, run_with_addon, script_words
from figure import Plan, make_figure
from figure_views import View
from mathutils import Matrix
from painting_discs import grow_disc, neighbours
from saving import save_blend

_FOLDER = Path(__file__).resolve().parents[1] / "build/demo"
_SUBDIVISIONS = 3  # 31 658 vertices
_PLAN = Plan(View(20, 10), View(-46, 14), (0.35, 0.55), levels=15)
# Name, value, part of all vertices per disc, and the points whose nearest vertices are the discs' centres. The eyes are
# pieces of their own, so each has two.
_PATCHES = (
    ("left ear", 1.0, 0.012, ((1.3, 0.35, 0.45),)),
    ("right ear", 0.0, 0.012, ((-1.3, 0.35, 0.45),)),
    ("crown", 0.3, 0.002, ((0.0, 0.0, 0.95),)),
    ("chin", 0.15, 0.010, ((0.0, -0.72, -0.95),)),
    ("snout", 0.65, 0.003, ((0.0, -0.82, -0.2),)),
    ("left cheek", 0.75, 0.004, ((0.5, -0.6, 0.0),)),
    ("back", 0.55, 0.002, ((0.0, 0.78, 0.3),)),
    ("pupils", 0.0, 0.007, ((0.35, -0.82, 0.26), (-0.35, -0.82, 0.26))),
    ("eye rims", 0.3, 0.004, ((0.6, -0.57, 0.26), (-0.6, -0.57, 0.26))),
)


def main(addon: ModuleType) -> None:
    library = part(addon, "library")
    parser = library.load("command_line").OneSentenceParser(prog="demo", description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, default=_FOLDER, help="where to write (default: build/demo)")
    parser.add_argument("--quick", action="store_true", help="no picture")
    parser.add_argument("--width", type=int, default=_PLAN.width, help="of one of the picture's six tiles, in pixels")
    args = parser.parse_args(script_words())
    obj = add_monkey()
    paint(addon, obj)
    obj.dirichlet.count = _PLAN.levels
    for operator in (bpy.ops.dirichlet.solve_field, bpy.ops.dirichlet.make_isolines):
        run(operator, library.load().InputError)
    show_everything()
    args.folder.mkdir(parents=True, exist_ok=True)
    files = [(args.folder / "demo.blend", save_blend)]
    if not args.quick:
        height = args.width * _PLAN.height // _PLAN.width
        sheet = make_figure(addon, obj, replace(_PLAN, width=args.width, height=height))
        files.append((args.folder / "demo.png", sheet.save))
    library.load("output").write_all(files)


def add_monkey() -> bpy.types.Object:
    """The only object of the file."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    bpy.ops.mesh.primitive_monkey_add()
    obj = bpy.context.active_object
    obj.name = obj.data.name = "Monkey"
    obj.modifiers.new("Subdivision", "SUBSURF").levels = _SUBDIVISIONS
    bpy.ops.object.modifier_apply(modifier="Subdivision")
    obj.data.polygons.foreach_set("use_smooth", np.ones(len(obj.data.polygons), bool))
    return obj


def paint(addon: ModuleType, obj: bpy.types.Object) -> None:
    """A vertex group and a patch for each of _PATCHES."""
    mesh = part(addon, "blender.mesh.meshes").read_mesh(obj.data)
    near = neighbours(mesh)
    for name, value, share, points in _PATCHES:
        centres = [int(np.linalg.norm(mesh.positions - point, axis=1).argmin()) for point in points]
        discs = [grow_disc(near, mesh.positions, centre, round(share * mesh.vertex_count)) for centre in centres]
        group = part(addon, "blender.mesh.groups").add_group(obj, name, np.concatenate(discs))
        bpy.ops.dirichlet.patch_add_group(group=group)
        obj.dirichlet.patches[-1].value = value


def run(operator: Callable[[], object], refusal: type[Exception]) -> None:
    """Runs an operator; what it reports as an error is raised as a refusal."""
    try:
        operator()
    except RuntimeError as error:
        sentence = str(error).strip().removeprefix("Error: ")
        if "\n" in sentence:  # a traceback, so a bug
            raise
        raise refusal(sentence) from error


def show_everything() -> None:
    """Opening the file shows the monkey's face in its colours, and the sidebar."""
    for screen in bpy.data.screens:
        for area in screen.areas:
            if area.type == "VIEW_3D":
                space = area.spaces.active
                space.shading.type, space.shading.color_type = "SOLID", "VERTEX"
                space.show_region_ui = True
                space.overlay.show_floor = space.overlay.show_axis_x = space.overlay.show_axis_y = False
                space.region_3d.view_rotation = Matrix(_PLAN.above.frame().T.tolist()).to_quaternion()
                space.region_3d.view_location, space.region_3d.view_distance = (0, 0, 0), 6


if __name__ == "__main__":
    sys.exit(run_with_addon("demo", main))
