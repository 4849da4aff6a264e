# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the built package on the path: build/release/python, or the folder that DIRICHLET_PYTHONPATH names."""

import os
import sys
from pathlib import Path

import pytest
from hypothesis import settings

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = Path(os.environ.get("DIRICHLET_PYTHONPATH", ROOT / "build" / "release" / "python"))

if not list(PACKAGES.glob("dirichlet_surface/_native*")):
    pytest.exit(
        f"dirichlet_surface is not built in {PACKAGES}: run `cmake --workflow --preset release`, "
        "or name the folder that holds it in DIRICHLET_PYTHONPATH",
        returncode=2,
    )
sys.path.insert(0, str(PACKAGES))

settings.register_profile("laws", deadline=None, derandomize=True, max_examples=60, print_blob=True)
settings.load_profile("laws")


@pytest.fixture(scope="session")
def real_mesh_folder() -> Path:
    """The real meshes that stand beside the repository, where they do."""
    folder = Path(os.environ.get("DIRICHLET_MESHES", ROOT.parent / "shared" / "meshes"))
    if not folder.is_dir():
        missing = f"no real meshes in {folder}; DIRICHLET_MESHES may name another folder"
        pytest.fail(missing) if "CI" in os.environ else pytest.skip(missing)
    return folder


@pytest.fixture(scope="session")
def package_path() -> str:
    """For PYTHONPATH of a fresh interpreter."""
    return str(PACKAGES)
