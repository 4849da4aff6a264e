# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of fields, isolines and reports. `write_all` makes it all or nothing."""

from __future__ import annotations

import io
import json
import os
import shutil
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._native import InputError
from .field import Field
from .lines import Isolines
from .mesh import Mesh, write_mesh
from .ramps import apply_ramp, srgb_bytes

EXACT = "%.17g"  # reads back as the same float64


def write_all(files: Sequence[tuple[Path, Callable[[Path], None]]]) -> None:
    """Calls every writer with a path beside its target and, when all are through, renames them into place.

    Raises InputError naming the target that cannot be written, or that two files share. Then no target is touched,
    unless it is a renaming that fails: the targets before that one are new already.
    """
    _check_targets([target for target, _ in files])
    places = [target.resolve() if target.is_symlink() else target for target, _ in files]  # a link stays one
    beside = [place.with_name(f".{os.getpid()}-{number}{place.suffix}") for number, place in enumerate(places)]
    target = path = Path()
    try:
        for (target, write), place, path in zip(files, places, beside):  # noqa: B007 (the errors below name the target)
            if place.exists():
                place.open("ab").close()  # a file that may not be written: the renaming would not ask
            write(path)
            if place.exists():
                shutil.copymode(place, path)
        for (target, _), place, path in zip(files, places, beside):  # noqa: B007
            os.replace(path, place)
    except OSError as error:
        raise InputError(f"cannot write '{target}': {error.strerror or error}") from error
    except InputError as error:  # of a writer that was told the path beside
        raise InputError(str(error).replace(str(path), str(target))) from error
    finally:
        for path in beside:
            path.unlink(missing_ok=True)


def _check_targets(targets: Sequence[Path]) -> None:
    """Before any writer runs, since some would make a missing folder."""
    places: set[Path] = set()
    for target in targets:
        if target.resolve() in places:
            raise InputError(f"two outputs go to '{target}'")
        if os.path.isdir(target):
            raise InputError(f"cannot write '{target}': it is a folder")
        if not os.path.isdir(target.parent):  # unlike Path.is_dir, False for what may not be looked at
            raise InputError(f"cannot write '{target}': there is no folder '{target.parent}'")
        places.add(target.resolve())


def write_field_npy(mesh: Mesh, field: Field, path: Path) -> None:
    """(V,) float64, NaN where undefined."""
    content = io.BytesIO()  # into a file NumPy writes by itself, and takes no notice of a disk that is full at the end
    np.save(content, field.values)
    path.write_bytes(content.getbuffer())


def write_field_csv(mesh: Mesh, field: Field, path: Path) -> None:
    """One row per vertex: vertex, x, y, z, value."""
    rows = np.column_stack((np.arange(mesh.vertex_count), mesh.positions, field.values))
    np.savetxt(path, rows, fmt=["%d", *[EXACT] * 4], delimiter=",", header="vertex,x,y,z,value", comments="")


def write_field_ply(mesh: Mesh, field: Field, path: Path) -> None:
    """The mesh with the field as vertex colours: the rainbow from its minimum to its maximum."""
    colors = apply_ramp(field.values, field.report.minimum, field.report.maximum)
    write_mesh(path, mesh, srgb_bytes(colors))


def write_lines_csv(mesh: Mesh, lines: Isolines, path: Path) -> None:
    """One row per point; a closed line does not repeat its first point."""
    line = np.repeat(np.arange(len(lines)), np.diff(lines.offsets))
    level = lines.level[line]
    rows = np.column_stack((line, level, lines.levels[level], lines.closed[line], lines.points, lines.edges, lines.t))
    header = "line,level,value,closed,x,y,z,edge_first,edge_second,t"
    formats = ["%d", "%d", EXACT, "%d", EXACT, EXACT, EXACT, "%d", "%d", EXACT]
    np.savetxt(path, rows, fmt=formats, delimiter=",", header=header, comments="")


def write_lines_json(mesh: Mesh, lines: Isolines, path: Path) -> None:
    """{"levels": [...], "lines": [{"level", "value", "closed", "length", "points", "edges", "t"}, ...]}."""
    entries = [
        {
            "level": line.level,
            "value": line.value,
            "closed": line.closed,
            "length": line.length,
            "points": lines.points[line.places].tolist(),
            "edges": lines.edges[line.places].tolist(),
            "t": lines.t[line.places].tolist(),
        }
        for line in _each(lines)
    ]
    write_json({"levels": lines.levels.tolist(), "lines": entries}, path)


def write_lines_obj(mesh: Mesh, lines: Isolines, path: Path) -> None:
    """Points as vertices, every line an `l` element in the group of its level; a closed line ends where it began."""
    with path.open("w", encoding="utf-8", newline="\n") as file:
        np.savetxt(file, lines.points, fmt=f"v {EXACT} {EXACT} {EXACT}")
        for line in _each(lines):
            corners = [*range(line.places.start + 1, line.places.stop + 1)]
            corners += corners[:1] if line.closed else []
            file.write(f"g level_{line.level}\nl {' '.join(map(str, corners))}\n")


def write_lines_svg(mesh: Mesh, lines: Isolines, path: Path) -> None:
    """Orthographic picture along the axis in which the mesh is thinnest (named in <desc>), 1000 units long.

    Seen from +x, -y or +z, so that the other two axes run to the right and up. Lines are coloured by level: rainbow.
    """
    low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
    thinnest = int(np.argmin(high - low))
    right, up = (axis for axis in range(3) if axis != thinnest)
    longest = max(high[right] - low[right], high[up] - low[up]) or 1.0
    place = 1000 * np.column_stack((lines.points[:, right] - low[right], high[up] - lines.points[:, up])) / longest
    width, height = 1000 * (high - low)[[right, up]] / longest
    colors = srgb_bytes(apply_ramp(lines.levels, *_ends(lines.levels)))
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-5 -5 {width + 10:.6g} {height + 10:.6g}">\n'
            f"<desc>Orthographic projection along the {'xyz'[thinnest]} axis, seen from "
            f"{('+x', '-y', '+z')[thinnest]}</desc>\n"
            '<g fill="none" stroke-width="2" stroke-linejoin="round" stroke-linecap="round">\n'
        )
        for line in _each(lines):
            element = "polygon" if line.closed else "polyline"
            points = " ".join(f"{x:.2f},{y:.2f}" for x, y in place[line.places])
            color = "#" + colors[line.level].tobytes().hex()
            file.write(f'<{element} class="level-{line.level}" stroke="{color}" points="{points}"/>\n')
        file.write("</g>\n</svg>\n")


def write_json(content: dict[str, Any], path: Path) -> None:
    with path.open("w", encoding="utf-8", errors="backslashreplace", newline="\n") as file:  # of names that are no text
        json.dump(content, file, indent=1, allow_nan=False, ensure_ascii=False)
        file.write("\n")


FIELD_WRITERS: dict[str, Callable[[Mesh, Field, Path], None]] = {
    ".npy": write_field_npy,
    ".csv": write_field_csv,
    ".ply": write_field_ply,
}
LINE_WRITERS: dict[str, Callable[[Mesh, Isolines, Path], None]] = {
    ".obj": write_lines_obj,
    ".csv": write_lines_csv,
    ".json": write_lines_json,
    ".svg": write_lines_svg,
}


class _Line(NamedTuple):
    places: slice  # of its points
    level: int
    value: float
    closed: bool
    length: float


def _each(lines: Isolines) -> Iterator[_Line]:
    """The lines one by one, as plain Python numbers."""
    columns = (lines.level, lines.levels[lines.level], lines.closed, lines.length)
    starts, ends = lines.offsets[:-1].tolist(), lines.offsets[1:].tolist()
    for start, end, *facts in zip(starts, ends, *(column.tolist() for column in columns)):
        yield _Line(slice(start, end), *facts)


def _ends(levels: NDArray[np.float64]) -> tuple[float, float]:
    return (float(levels.min()), float(levels.max())) if levels.size else (0.0, 0.0)
