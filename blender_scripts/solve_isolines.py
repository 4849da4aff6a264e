# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves for a field and draws isolines without a window, with the words of `python -m dirichlet_surface`.

blender --background [FILE.blend] --python blender_scripts/solve_isolines.py -- [MESHFILE] [--object NAME]
    [--group NAME=VALUE]... [--patch NAME=VALUE@PLACE]... [--isolines N]... [--save OUT.blend] [--render OUT.png]
Values are kept in single precision, as Blender keeps all of them. Without --overlap, --laplacian and --method it is as
the object's settings say.
Exit code 0; or 2 after one sentence on stderr, and then nothing is written.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import ModuleType

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from addon_loader import part, run_with_addon, script_words
from mesh_object import add_mesh_object
from saving import render_object, save_blend

_SETTINGS = ("overlap", "laplacian", "method")  # words that are settings of the object, too
_SUMMARY = f"{__doc__.splitlines()[0]} The patches' values are kept in single precision."


def main(addon: ModuleType) -> None:
    library = part(addon, "library")
    command_line, pipeline = library.load("command_line"), part(addon, "blender.pipeline")
    args = parse(command_line)
    obj = choose_object(library.load(), args)
    set_patches(addon, obj, args)
    solved = pipeline.solve_field(obj)
    lines = make_isolines(addon, obj, solved.mesh, args)
    patches = part(addon, "blender.paint.painting").read_patches(obj)
    command_line.write_outputs(
        args, solved.mesh, solved.field, lines, patches, solved.painting.warnings, also=blender_files(addon, obj, args)
    )
    report(obj, solved, lines, [args.save, args.render, args.out_field, args.out_lines, args.report])


def parse(command_line: ModuleType) -> argparse.Namespace:
    parser = command_line.OneSentenceParser(prog="solve_isolines", description=_SUMMARY)
    parser.add_argument("mesh", nargs="?", type=Path, metavar="MESHFILE", help=".obj .ply .off .stl; added to the file")
    parser.add_argument("--object", metavar="NAME", help="mesh object of the file (default: the only one)")
    parser.add_argument(
        "--group", dest="groups", action="append", type=_group, default=[], metavar="NAME=VALUE",
        help="give VALUE to a vertex group; without --group and --patch the add-on's patches of the object are used",
    )  # fmt: skip
    command_line.add_arguments(parser)
    parser.add_argument("--save", type=_ending(".blend"), metavar="OUT.blend", help="the file with field and isolines")
    parser.add_argument("--render", type=_ending(".png"), metavar="OUT.png", help="a picture of the object")
    parser.add_argument("--size", type=int, nargs=2, default=(1200, 1000), metavar=("W", "H"), help="of the picture")
    parser.set_defaults(**dict.fromkeys(_SETTINGS))
    args = parser.parse_args(command_line.shield_numbers(script_words()))
    if args.mesh and args.object:
        parser.error("name a mesh file or an object, not both")
    if min(args.size) < 16 or max(args.size) > 16384:
        parser.error(f"a picture of {args.size[0]} by {args.size[1]} pixels is not between 16 and 16384")
    return args


def choose_object(surface: ModuleType, args: argparse.Namespace) -> bpy.types.Object:
    """The mesh file as an object, the object named, or the only mesh object. Raises InputError."""
    if args.mesh:
        return add_mesh_object(surface.read_mesh(args.mesh), args.mesh.stem)
    meshes = {obj.name: obj for obj in bpy.context.scene.objects if obj.type == "MESH"}
    if args.object is not None:
        if args.object not in meshes:
            raise surface.InputError(f"there is no mesh object '{args.object}'; there is {_listed(meshes)}")
        return meshes[args.object]
    if len(meshes) != 1:
        raise surface.InputError(f"which object? name it with --object; there is {_listed(meshes)}")
    return next(iter(meshes.values()))


def set_patches(addon: ModuleType, obj: bpy.types.Object, args: argparse.Namespace) -> None:
    """Puts the groups and patches asked for into the add-on's list; nothing asked for leaves the list as it is."""
    surface, settings = part(addon, "library").load(), obj.dirichlet
    for name in _SETTINGS:
        setattr(settings, name, getattr(args, name) or getattr(settings, name))
    if not args.groups and not args.patches:
        return
    positions = part(addon, "blender.mesh.meshes").read_positions(obj.data)
    patches = [argument.to_patch(positions) for argument in args.patches]
    patches = [replace(patch, values=_single(surface, patch.name, patch.values)) for patch in patches]
    groups = [(name, _single(surface, name, value)) for name, value in args.groups]
    settings.patches.clear()
    for name, value in groups:
        _list_patch(settings, name, value)
    asked_for = [*part(addon, "blender.paint.painting").read_patches(obj), *patches]
    surface.combine_patches(asked_for, len(positions), settings.overlap)  # groups drop vertices outside in silence
    for patch in patches:
        group = part(addon, "blender.mesh.groups").add_group(obj, patch.name, patch.vertices)
        _list_patch(settings, group, patch.values)


def _single(surface: ModuleType, name: str, value: float) -> float:
    """The value as Blender keeps it. Raises InputError for one that Blender would clamp."""
    if abs(value) > float(np.finfo(np.float32).max):  # compared in double: NumPy 2 would round the value first
        raise surface.InputError(f"patch '{name}' has the value {value}, which is beyond Blender's single precision")
    return float(np.float32(value))


def _list_patch(settings: bpy.types.PropertyGroup, group: str, value: float) -> None:
    patch = settings.patches.add()
    patch.group, patch.value = group, value


def make_isolines(addon: ModuleType, obj: bpy.types.Object, mesh, args: argparse.Namespace):
    """The library's Isolines, drawn as the add-on's curve object where there is any level."""
    library = part(addon, "library")
    values = part(addon, "blender.mesh.attributes").read_field(obj.data)
    levels = library.load("command_line").choose_levels(args, mesh, values)
    if not len(levels):
        return library.load().isolines(mesh, values, levels)
    obj.dirichlet.levels_mode = "LIST"
    obj.dirichlet.levels_list = ", ".join(map(repr, levels.tolist()))
    if args.render:
        obj.dirichlet.output = "CURVE"  # nothing else has a thickness in a picture
    return part(addon, "blender.pipeline").make_isolines(obj).lines


def blender_files(
    addon: ModuleType, obj: bpy.types.Object, args: argparse.Namespace
) -> list[tuple[Path, Callable[[Path], None]]]:
    files: list[tuple[Path, Callable[[Path], None]]] = []
    if args.save:
        files.append((args.save, save_blend))
    if args.render:
        files.append((args.render, partial(render_object, addon, obj, args.size)))
    return files


def report(obj: bpy.types.Object, solved, lines, paths: list[Path | None]) -> None:
    closed = int(lines.closed.sum())
    taken = solved.field.report
    print(f"{obj.name}: {taken.summary()}")
    if taken.reason:
        print(f"laplacian: {taken.laplacian}, as {taken.reason}")
    print(f"isolines: {len(lines)} on {len(lines.levels)} levels, {closed} closed, {len(lines) - closed} open")
    for warning in (*solved.warnings, *lines.warnings):
        print(f"warning: {warning}")
    for path in filter(None, paths):
        print(f"wrote {path}")


def _group(text: str) -> tuple[str, float]:
    name, equals, value = text.rpartition("=")
    try:
        return (name, float(value)) if name and equals else _refuse(text)
    except ValueError:
        return _refuse(text)


def _refuse(text: str) -> tuple[str, float]:
    raise argparse.ArgumentTypeError(f"'{text}' is not NAME=VALUE")


def _ending(ending: str) -> Callable[[str], Path]:
    def path_with_ending(text: str) -> Path:
        if Path(text).suffix.lower() != ending:
            raise argparse.ArgumentTypeError(f"'{text}' does not end in {ending}")
        return Path(text)

    return path_with_ending


def _listed(names) -> str:
    return ", ".join(f"'{name}'" for name in names) or "none"


if __name__ == "__main__":
    sys.exit(run_with_addon("solve_isolines", main))
