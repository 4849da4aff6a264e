# SPDX-License-Identifier: GPL-3.0-or-later
"""Has a Blender install the add-on's zip that is for it, and puts what came of it into one folder, for the tests:

python3 install_archive.py BLENDER FOLDER-OF-ZIPS FOLDER     prints the folder of the add-on
"""

import shutil
import sys
from pathlib import Path

import archives
import configuration


def install(blender: str, archive: Path, folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    configuration.install(blender, configuration.empty(folder), archive)
    installed = next(path.parent for path in folder.rglob("dirichlet_isolines/__init__.py"))
    library = next(path.parent for path in folder.rglob("dirichlet_surface/__init__.py"))
    if installed not in library.parents:  # an extension's wheel is unpacked elsewhere, for all extensions
        shutil.copytree(library, installed / "dirichlet_surface")
    return installed


if __name__ == "__main__":
    zips = Path(sys.argv[2])
    print(install(sys.argv[1], archives.choose(sys.argv[1], zips), Path(sys.argv[3]).resolve()))
