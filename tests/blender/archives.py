# SPDX-License-Identifier: GPL-3.0-or-later
"""The staged add-on, and its zips: those in the folder DIRICHLET_DIST, else of sources and staged library."""

import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STAGED = Path(os.environ.get("DIRICHLET_ADDON", ROOT / "build/release/addon/dirichlet_isolines"))
sys.path.insert(0, str(ROOT / "blender_scripts"))
import package_extension  # noqa: E402


def make_wheel(package: Path, version: str, folder: Path) -> Path:
    """As pip would install it, for the Python that the package's module was built for."""
    module = next(package.glob("_native.*"))
    python = "cp" + re.search(r"cpython-(\d+)", module.name).group(1)
    target = folder / f"dirichlet_surface-{version}-{python}-{python}-linux_x86_64.whl"
    information = f"dirichlet_surface-{version}.dist-info"
    texts = {
        "METADATA": f"Metadata-Version: 2.1\nName: dirichlet-surface\nVersion: {version}\n",
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: tests\nRoot-Is-Purelib: false\nTag: {python}-{python}-linux_x86_64\n",
    }
    with zipfile.ZipFile(target, "w") as archive:
        for path in sorted(path for path in package.rglob("*") if path.is_file() and path.suffix != ".pyc"):
            archive.write(path, f"dirichlet_surface/{path.relative_to(package)}")
        for name, text in texts.items():
            archive.writestr(f"{information}/{name}", text)
        names = [*archive.namelist(), f"{information}/RECORD"]
        archive.writestr(f"{information}/RECORD", "".join(f"{name},,\n" for name in names))
    return target


def blender_version(blender: str) -> tuple[int, ...]:
    told = subprocess.run([blender, "--version"], capture_output=True, text=True, check=True).stdout
    return tuple(map(int, re.search(r"Blender (\d+)\.(\d+)", told).groups()))


def archive_for(blender: str, folder: Path) -> Path:
    """For the user of this Blender."""
    if os.environ.get("DIRICHLET_DIST"):
        return choose(blender, Path(os.environ["DIRICHLET_DIST"]))
    return make_archive_for(blender, folder, package_extension.project_version())


def make_archive_for(blender: str, folder: Path, version: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    package_extension.make(folder, [make_wheel(STAGED / "dirichlet_surface", version, folder)], version)
    return choose(blender, folder, version)


def choose(blender: str, folder: Path, version: str = package_extension.project_version()) -> Path:
    """The extension from Blender 4.2 on, the legacy add-on before."""
    kind = "" if blender_version(blender) >= (4, 2) else "-legacy"
    return folder / f"{package_extension.NAME}-{version}{kind}.zip"
