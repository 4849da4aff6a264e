# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test starts in an empty file, with the staged add-on registered."""

import importlib
import sys

import bpy
import pytest
from archives import STAGED
from following import settle
from scene import painted_grid, painted_sphere

if not (STAGED / "__init__.py").is_file():
    pytest.exit(f"there is no add-on in {STAGED}: build it first, or name its folder in DIRICHLET_ADDON", returncode=2)
sys.path.insert(0, str(STAGED.parent))


@pytest.fixture(scope="session")
def addon():
    """The add-on's module, registered."""
    module = importlib.import_module(STAGED.name)
    module.register()
    yield module
    module.unregister()


@pytest.fixture(scope="session")
def surface(addon):
    """The library as the add-on finds it."""
    return importlib.import_module(f"{addon.__name__}.library").load()


@pytest.fixture(scope="session")
def pipeline(addon, surface):
    return importlib.import_module(f"{addon.__name__}.blender.pipeline")


@pytest.fixture
def module(addon, surface):
    """A module of the add-on's that touches Blender's data, by its name."""
    return lambda name: importlib.import_module(f"{addon.__name__}.blender.{name}")


@pytest.fixture(autouse=True)
def _empty_file(addon):
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)


@pytest.fixture
def sphere():
    """Closed, solved between 0 and 1."""
    obj = painted_sphere()
    bpy.ops.dirichlet.solve_field()
    return obj


@pytest.fixture
def sheet():
    """Solved: x / 8 on columns 0 to 8."""
    obj = painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    return obj


@pytest.fixture
def live(addon):
    return importlib.import_module(f"{addon.__name__}.blender.live")


@pytest.fixture
def grid_live(live):
    """A painted grid, solved, with Live on and nothing pending."""
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    obj.dirichlet.live = True
    settle(live)
    return obj
