# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the add-on's zips of its sources and the library's wheels: package_extension.py FOLDER WHEEL…

    FOLDER/dirichlet_isolines-VERSION.zip           extension for Blender 4.2 and later, with all of the wheels
    FOLDER/dirichlet_isolines-VERSION-legacy.zip    add-on for earlier ones, with the library for their Python inside

The same input gives the same bytes: names are sorted, times and permissions fixed.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

from extension_rules import LEGACY_TAG, RuleError, check_extension, check_legacy, platform_of, read_wheel_name

ROOT = Path(__file__).resolve().parents[1]
NAME = "dirichlet_isolines"
EARLIEST_ZIP_TIME = (1980, 1, 1, 0, 0, 0)


def project_version() -> str:
    return re.search(r"project\(dirichlet_surface VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def stage(folder: Path, version: str, package: Path | None = None) -> None:
    """The add-on as it ships, into the folder; with the library inside when its package is named."""
    facts = {"ADDON": ROOT / "addon", "VERSION": version, "STAGE": folder, "PACKAGE": package or ""}
    words = [word for name, value in facts.items() for word in ("-D", f"{name}={value}")]
    subprocess.run(["cmake", *words, "-P", str(ROOT / "addon" / "stage.cmake")], check=True)


def fill_in_wheels(manifest: Path, wheels: list[Path]) -> None:
    platforms = sorted({platform for wheel in wheels for platform in read_wheel_name(wheel.name).platforms})
    paths = [f"./wheels/{wheel.name}" for wheel in wheels]
    text = manifest.read_text()
    text = re.sub(r"^platforms = .*$", f"platforms = {json.dumps(platforms)}", text, flags=re.MULTILINE)
    manifest.write_text(re.sub(r"^wheels = .*$", f"wheels = {json.dumps(paths, indent=2)}", text, flags=re.MULTILINE))


def write_extension(target: Path, version: str, wheels: list[Path], folder: Path) -> None:
    staged = folder / NAME
    stage(staged, version)
    fill_in_wheels(staged / "blender_manifest.toml", wheels)
    (staged / "wheels").mkdir()
    for wheel in wheels:
        shutil.copy(wheel, staged / "wheels")
    write_zip(target, staged, staged)


def write_legacy(target: Path, version: str, wheel: Path, folder: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder / "wheel")
    stage(folder / "legacy" / NAME, version, folder / "wheel" / "dirichlet_surface")
    (folder / "legacy" / NAME / "blender_manifest.toml").unlink()  # else later Blenders take it for an extension
    write_zip(target, folder / "legacy" / NAME, folder / "legacy")


def files_to_ship(staged: Path) -> Iterator[Path]:
    return (path for path in sorted(staged.rglob("*")) if path.is_file())


def write_zip(target: Path, staged: Path, names_from: Path) -> None:
    """Beside the target, then renamed: whoever reads it never sees half a zip."""
    beside = target.with_suffix(".part")
    with zipfile.ZipFile(beside, "w") as archive:
        for path in files_to_ship(staged):
            entry = zipfile.ZipInfo(path.relative_to(names_from).as_posix(), EARLIEST_ZIP_TIME)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_STORED if path.suffix == ".whl" else zipfile.ZIP_DEFLATED
            archive.writestr(entry, path.read_bytes(), compresslevel=9)
    os.replace(beside, target)


def print_content(target: Path) -> None:
    with zipfile.ZipFile(target) as archive:
        for entry in archive.infolist():
            print(f"{entry.file_size:>10}  {entry.filename}")
    print(f"{target}: {target.stat().st_size / 1e6:.2f} MB\n")


def wheel_for_legacy(wheels: list[Path]) -> Path | None:
    """The zip has room for one: that for this machine, else the only one; None where that leaves a choice."""
    fitting = [wheel for wheel in wheels if read_wheel_name(wheel.name).python == LEGACY_TAG]
    here = platform_of(re.sub("[-.]", "_", sysconfig.get_platform()))
    of_here = [wheel for wheel in fitting if here in read_wheel_name(wheel.name).platforms]
    return next((choice[0] for choice in (of_here, fitting) if len(choice) == 1), None)


def make(out: Path, wheels: list[Path], version: str) -> list[Path]:
    """Both zips, or all but the legacy one where there is no wheel for it. Raises RuleError."""
    out.mkdir(parents=True, exist_ok=True)
    extension, legacy = out / f"{NAME}-{version}.zip", out / f"{NAME}-{version}-legacy.zip"
    of_legacy = wheel_for_legacy(wheels)
    with tempfile.TemporaryDirectory() as folder:
        write_extension(extension, version, wheels, Path(folder))
        check_extension(extension, version)
        if not of_legacy:
            return [extension]
        write_legacy(legacy, version, of_legacy, Path(folder))
        check_legacy(legacy, version)
    return [extension, legacy]


def main(out: Path, wheels: list[Path]) -> None:
    made = make(out, wheels, project_version())
    for target in made:
        print_content(target)
    if len(made) == 1:
        print(f"No zip for Blender before 4.2: that takes one wheel for {LEGACY_TAG}, of several that for this machine")


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]), sorted(map(Path, sys.argv[2:]), key=lambda wheel: wheel.name))
    except RuleError as error:
        raise SystemExit(f"package_extension.py: {error}") from None
