# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender and its users may rely on in the add-on's two zips, checked before they are given to anybody."""

from __future__ import annotations

import ast
import re
import tomllib
import zipfile
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

LEGACY_TAG = "cp311"  # the Python of the oldest supported Blender, 3.4 as Debian 12 builds it, and of the official 4.1
REQUIRED = ("schema_version", "id", "version", "name", "tagline", "maintainer", "type", "blender_version_min", "tags")
_PLATFORMS = {
    r"(many|musl)?linux(_\d+_\d+|\d*)_x86_64": "linux-x64",
    r"(many|musl)?linux(_\d+_\d+|\d*)_aarch64": "linux-arm64",
    r"macosx_\d+_\d+_arm64": "macos-arm64",
    r"macosx_\d+_\d+_x86_64": "macos-x64",
    r"win_amd64": "windows-x64",
    r"win_arm64": "windows-arm64",
}
_MOST_BYTES = 15_000_000  # for each platform
_EARLIEST = (4, 2, 0), (3, 4, 0)  # Blender of extensions, and of bl_info


class RuleError(Exception):
    """A rule that does not hold, in a sentence that names the place."""


class Wheel(NamedTuple):
    """What the name of a wheel says; platforms as Blender calls them."""

    distribution: str
    version: str
    python: str
    platforms: tuple[str, ...]


def platform_of(tag: str) -> str | None:
    """Blender's name of a wheel's platform; None where it has none."""
    return next((place for known, place in _PLATFORMS.items() if re.fullmatch(known, tag)), None)


def read_wheel_name(name: str) -> Wheel:
    """Raises RuleError where Blender could not tell for whom the wheel is."""
    parts = name.removesuffix(".whl").split("-")
    if not name.endswith(".whl") or len(parts) != 5:
        raise RuleError(f"{name} is no name of a wheel: distribution-version-python-abi-platform.whl")
    distribution, version, python, abi, tags = parts
    if python != abi or not re.fullmatch(r"cp3\d+", python):
        raise RuleError(f"{name} is for {python}-{abi}, expected one version of CPython, such as cp311-cp311")
    platforms = {place for tag in tags.split(".") if (place := platform_of(tag))}
    if not platforms:
        raise RuleError(f"{name} is for '{tags}', which is no platform of Blender")
    return Wheel(distribution, version, python, tuple(sorted(platforms)))


def read_bl_info(source: str) -> dict[str, Any]:
    """Blender parses bl_info as a literal without running the file; so do we."""
    for statement in ast.parse(source).body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "bl_info":
            return dict(ast.literal_eval(statement.value))
    raise RuleError("__init__.py has no bl_info")


def check_extension(archive: Path, version: str) -> None:
    """Raises RuleError."""
    with zipfile.ZipFile(archive) as content:
        names = content.namelist()
        manifest = tomllib.loads(content.read("blender_manifest.toml").decode())
        bl_info = read_bl_info(content.read("__init__.py").decode())
        for wheel in names:
            if wheel.endswith(".whl"):
                with zipfile.ZipFile(content.open(wheel)) as inside:
                    _check_terms(PurePosixPath(wheel).name, inside.namelist())
    _check_names(archive, names)
    _check_manifest(manifest)
    _check_size(archive, len(manifest["platforms"]))
    _check_agreement(manifest, bl_info, version)
    _check_wheels(manifest, [name for name in names if name.endswith(".whl")])


def check_legacy(archive: Path, version: str) -> None:
    """Raises RuleError."""
    with zipfile.ZipFile(archive) as content:
        names = content.namelist()
        top = PurePosixPath(names[0]).parts[0]
        found = ".".join(map(str, read_bl_info(content.read(f"{top}/__init__.py").decode())["version"]))
    _check_names(archive, names)
    _check_size(archive, 1)
    _check_terms(archive.name, names)
    if found != version:
        raise RuleError(f"version differs: {version!r} in the project, {found!r} in bl_info")
    if not any(name.startswith(f"{top}/dirichlet_surface/_native.") for name in names):
        raise RuleError(f"{archive.name} lacks the compiled library")


def _check_names(archive: Path, names: list[str]) -> None:
    for name in names:
        if re.search(r"__pycache__|\.pyc$|(^|/)\.(?!dylibs/)", name):
            raise RuleError(f"{archive.name} holds {name}, which nobody needs")


def _check_size(archive: Path, platforms: int) -> None:
    if archive.stat().st_size > platforms * _MOST_BYTES:
        raise RuleError(f"{archive.name} has {archive.stat().st_size} bytes, more than {platforms * _MOST_BYTES}")


def _check_terms(holder: str, names: list[str]) -> None:
    """A library of others travels with its terms."""
    if any("libOpenMesh" in name for name in names) and not any(
        name.endswith("dirichlet_surface/licenses/OpenMesh.txt") for name in names
    ):
        raise RuleError(f"{holder} holds OpenMesh without its terms, dirichlet_surface/licenses/OpenMesh.txt")


def _check_agreement(manifest: dict[str, Any], bl_info: dict[str, Any], version: str) -> None:
    """Each fact that stands in several places."""
    facts = {
        "version": {"the project": version, "the manifest": manifest["version"],
                    "bl_info": ".".join(map(str, bl_info["version"]))},
        "name": {"the manifest": manifest["name"], "bl_info": bl_info["name"]},
        "tagline": {"the manifest": manifest["tagline"], "bl_info": bl_info["description"]},
        "maintainer": {"the manifest": manifest["maintainer"], "bl_info": bl_info["author"]},
    }  # fmt: skip
    for fact, places in facts.items():
        if len(set(places.values())) > 1:
            raise RuleError(f"{fact} differs: " + ", ".join(f"{value!r} in {place}" for place, value in places.items()))
    if _numbers(manifest["blender_version_min"]) < _EARLIEST[0] or bl_info["blender"] != _EARLIEST[1]:
        found = f"{manifest['blender_version_min']} in the manifest, {bl_info['blender']} in bl_info"
        raise RuleError(f"the earliest Blender is {found}, not {_EARLIEST[0]} or later and {_EARLIEST[1]}")
    if bl_info["category"] not in manifest["tags"]:
        raise RuleError(f"bl_info's category {bl_info['category']!r} is none of the manifest's tags")


def _numbers(version: str) -> tuple[int, ...]:
    if not re.fullmatch(r"\d+\.\d+\.\d+", version):
        raise RuleError(f"the version {version!r} is not of three numbers, such as 4.2.0")
    return tuple(map(int, version.split(".")))


def _check_manifest(manifest: dict[str, Any]) -> None:
    missing = [key for key in (*REQUIRED, "license") if not manifest.get(key)]
    if missing:
        raise RuleError(f"the manifest has no {', '.join(missing)}")
    if manifest.get("permissions"):
        raise RuleError(f"the manifest asks for {', '.join(manifest['permissions'])}, which the add-on does not need")
    if len(manifest["tagline"]) > 64 or not manifest["tagline"][-1].isalnum():
        raise RuleError("the tagline is longer than 64 letters, or ends with a full stop")
    if not all(name.startswith("SPDX:") for name in manifest["license"]):
        raise RuleError("the licence is no SPDX name, such as SPDX:GPL-3.0-or-later")
    if not manifest.get("website", "https://").startswith("https://"):
        raise RuleError(f"the website {manifest['website']!r} does not begin with https://")
    if not {"__pycache__/", "*.pyc", ".*"} <= set(manifest.get("build", {}).get("paths_exclude_pattern", ())):
        raise RuleError("the manifest's paths_exclude_pattern leaves compiled or hidden files in")


def _check_wheels(manifest: dict[str, Any], held: list[str]) -> None:
    listed = [path.removeprefix("./") for path in manifest["wheels"]]
    if sorted(listed) != sorted(held):
        raise RuleError(f"the manifest lists the wheels {sorted(listed)}, the zip holds {sorted(held)}")
    wheels = [read_wheel_name(PurePosixPath(name).name) for name in listed]
    for wheel in wheels:
        if wheel.version != manifest["version"]:
            raise RuleError(f"the wheel for {wheel.python} has version {wheel.version}, not {manifest['version']}")
    pairs = [(wheel.python, place) for wheel in wheels for place in wheel.platforms]
    for python, place in pairs:
        if pairs.count((python, place)) > 1:
            raise RuleError(f"there are several wheels for {python} on {place}, of which Blender takes any")
    platforms = sorted({place for _, place in pairs})
    if platforms != sorted(manifest["platforms"]):
        raise RuleError(f"the manifest says platforms {manifest['platforms']}, the wheels are for {platforms}")
