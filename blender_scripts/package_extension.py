# SPDX-License-Identifier: GPL-3.0-or-later
"""Zips the staged add-on for Blender's Preferences > Add-ons > Install: package_extension.py STAGED-FOLDER OUT-FOLDER.

The same staged files give the same bytes: names are sorted, times and permissions fixed.
"""

from __future__ import annotations

import ast
import os
import re
import sys
import tomllib
import zipfile
from pathlib import Path

EARLIEST_ZIP_TIME = (1980, 1, 1, 0, 0, 0)


def project_version() -> str:
    cmake = Path(__file__).resolve().parent.parent / "CMakeLists.txt"
    return re.search(r"project\(dirichlet_surface VERSION ([0-9.]+)", cmake.read_text()).group(1)


def bl_info_version(staged: Path) -> str:
    """Blender parses bl_info as a literal without running the file; so do we."""
    for statement in ast.parse((staged / "__init__.py").read_text()).body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "bl_info":
            return ".".join(map(str, ast.literal_eval(statement.value)["version"]))
    raise SystemExit(f"{staged}/__init__.py has no bl_info")


def check_versions(staged: Path, version: str) -> None:
    found = {
        "bl_info": bl_info_version(staged),
        "blender_manifest.toml": tomllib.loads((staged / "blender_manifest.toml").read_text())["version"],
    }
    for place, other in found.items():
        if other != version:
            raise SystemExit(f"{place} says version {other}, CMakeLists.txt says {version}")


def files_to_ship(staged: Path) -> list[Path]:
    return sorted(path for path in staged.rglob("*") if path.is_file() and "__pycache__" not in path.parts)


def write_zip(staged: Path, target: Path) -> None:
    """Beside the target, then renamed: whoever reads it never sees half a zip."""
    beside = target.with_suffix(".part")
    with zipfile.ZipFile(beside, "w") as archive:
        for path in files_to_ship(staged):
            name = f"{staged.name}/{path.relative_to(staged).as_posix()}"
            entry = zipfile.ZipInfo(name, EARLIEST_ZIP_TIME)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, path.read_bytes(), compresslevel=9)
    os.replace(beside, target)


def print_content(target: Path) -> None:
    with zipfile.ZipFile(target) as archive:
        for entry in archive.infolist():
            print(f"{entry.file_size:>10}  {entry.filename}")
    print(f"{target}: {target.stat().st_size / 1e6:.2f} MB")


def main(staged: Path, folder: Path) -> None:
    version = project_version()
    check_versions(staged, version)
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{staged.name}-{version}.zip"
    write_zip(staged, target)
    print_content(target)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
