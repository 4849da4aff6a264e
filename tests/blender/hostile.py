# SPDX-License-Identifier: GPL-3.0-or-later
"""The surfaces and the damages of the Python tests, as arrays that Blender can store."""

import importlib
import sys

import numpy as np
from archives import ROOT, STAGED

sys.path.append(str(ROOT / "tests" / "python"))  # behind this folder: both have a conftest
sys.modules.setdefault("dirichlet_surface", importlib.import_module(f"{STAGED.name}.dirichlet_surface"))

import damage  # noqa: E402
from mesh_makers import ZOO, polygons  # noqa: E402

WHOLE = ZOO["quad grid"]
BEYOND_BLENDER = {"huge", "tiny"}  # of what single precision can store


def all_soups():
    """{name: (positions (V, 3) float32, faces)} of every surface, and of one for every damage."""
    soups = dict(ZOO)
    for name in sorted(damage.KINDS.keys() - BEYOND_BLENDER):
        soups[name] = damage.KINDS[name](WHOLE, np.random.default_rng(0))
    soups["as large as can be"] = damage.rescaled(WHOLE, 3e38)
    soups["as small as can be"] = damage.rescaled(WHOLE, 1e-42)
    return {name: (soup.positions.astype(np.float32), soup.faces) for name, soup in soups.items()}


def library_mesh(surface, positions, faces):
    return surface.Mesh(positions.astype(float), polygons(faces))
