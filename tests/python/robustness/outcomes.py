# SPDX-License-Identifier: GPL-3.0-or-later
"""The promised outcomes, through the library and on the command line: works, works with a warning, or is refused."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from dirichlet_surface import DirichletError, Field, Isolines, Mesh, even_levels, isolines, solve
from dirichlet_surface.command_line import main
from isoline_laws import assert_sound
from mesh_makers import Soup

OUTPUTS = ("--out-field", "field.npy", "--out-lines", "lines.obj", "--report", "report.json")

#: Laplacians that keep a field in the painted range on every mesh.
KEEP_THE_RANGE = ("graph", "intrinsic_delaunay", "auto")


def refusal(call, *arguments, **options) -> str:
    """The one sentence with which a call is refused."""
    try:
        call(*arguments, **options)
    except DirichletError as error:
        message = str(error)
    else:
        raise AssertionError("accepted")
    assert message
    assert "\n" not in message
    return message


def solved(mesh: Mesh, vertices, values, laplacian: str = "graph", count: int = 7) -> tuple[Field, Isolines]:
    """A field and its lines, which keep every promise."""
    vertices, values = np.asarray(vertices), np.asarray(values, float)
    field = solve(mesh, vertices, values, laplacian=laplacian)
    np.testing.assert_array_equal(field.values[vertices], values)
    undefined = np.isnan(field.values)
    assert np.isfinite(field.values[~undefined]).all()
    assert np.count_nonzero(undefined) == field.report.undefined
    if laplacian in KEEP_THE_RANGE:
        assert values.min() <= field.report.minimum
        assert field.report.maximum <= values.max()
    low, high = field.report.minimum, field.report.maximum
    lines = isolines(mesh, field.values, even_levels(low, high, count) if low < high else [])
    assert_sound(mesh, field.values, lines)
    return field, lines


def warning_about(words: str, warnings) -> str:
    """The one warning that has these words."""
    (found,) = [warning for warning in warnings if words in warning]
    assert "\n" not in found
    return found


def obj_of(soup: Soup) -> str:
    """An OBJ file, written down anew."""
    vertices = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in soup.positions.tolist())
    return vertices + "".join(f"f {' '.join(str(vertex + 1) for vertex in face)}\n" for face in soup.faces)


class Command:
    """`python -m dirichlet_surface` in the folder of the test."""

    def __init__(self, capfd) -> None:
        self._capfd = capfd

    def write(self, name: str, content: str | bytes) -> str:
        Path(name).write_bytes(content.encode() if isinstance(content, str) else content)
        return name

    def paint(self, name: str, value: float, vertices) -> list[str]:
        """The words that paint these vertices."""
        self.write(f"{name}.txt", " ".join(map(str, vertices)))
        return ["--patch", f"{name}={value!r}@{name}.txt"]

    def accepts(self, *words: str) -> str:
        """What it prints."""
        code = main(words)
        out, err = self._capfd.readouterr()
        assert (code, err) == (0, "")
        return out

    def refuses(self, *words: str, outputs: Sequence[str] = OUTPUTS) -> str:
        """The sentence it prints, after making sure that it wrote nothing."""
        before = snapshot()
        try:
            code = main([*words, *outputs])
        except SystemExit as stop:  # the way of argparse
            code = stop.code
        out, err = self._capfd.readouterr()
        assert (code, out) == (2, "")
        assert err.startswith("dirichlet_surface: ")
        assert err.count("\n") == 1
        assert snapshot() == before
        return err


def snapshot() -> dict[str, bytes]:
    """Every file of the test's folder."""
    return {path.name: path.read_bytes() for path in sorted(Path().iterdir())}
