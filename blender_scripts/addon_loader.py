# SPDX-License-Identifier: GPL-3.0-or-later
"""The one place where scripts find the add-on and the library."""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from types import ModuleType

ADDON = "dirichlet_isolines"
LIBRARY = "dirichlet_surface"
_ROOT = Path(__file__).resolve().parents[1]


class NotFoundError(Exception):
    """What was looked for, where, and how to make it."""


def script_words() -> list[str]:
    """The command line behind `--` under Blender, else all of it."""
    if "--" in sys.argv:
        return sys.argv[sys.argv.index("--") + 1 :]
    return [] if "bpy" in sys.modules else sys.argv[1:]


def load_addon() -> ModuleType:
    """The add-on, registered: from the folder that DIRICHLET_ADDON names, else installed, else built in this tree.

    Raises NotFoundError.
    """
    named = os.environ.get("DIRICHLET_ADDON")
    module = None if named else _enable_installed()
    if module:
        return module
    folder = Path(named).resolve() if named else _ROOT / "build/release/addon" / ADDON
    if not (folder / "__init__.py").is_file():
        raise NotFoundError(f"there is no add-on in {folder}: build it with ./run demo, or name it in DIRICHLET_ADDON")
    sys.path.insert(0, str(folder.parent))
    module = importlib.import_module(folder.name)
    module.register()
    return module


def load_library() -> ModuleType:
    """dirichlet_surface without Blender: an importable one, else that built in this tree. Raises NotFoundError."""
    folder = _ROOT / "build/release/python"
    if importlib.util.find_spec(LIBRARY) is None:
        sys.path.insert(0, str(folder))
    try:
        return importlib.import_module(LIBRARY)
    except ImportError as error:
        raise NotFoundError(
            f"{LIBRARY} is not installed, nor usable in {folder} ({error}): ./run demo builds it"
        ) from None


def run_with_addon(name: str, work: Callable[[ModuleType], None]) -> int:
    """Runs the work with the add-on; its exit code: 0, or 2 after one sentence on stderr."""
    refusals: tuple[type[Exception], ...] = (NotFoundError,)
    try:
        addon = load_addon()
        library = part(addon, "library")
        with suppress(library.LibraryMissingError):  # refused below, by whoever needs it first
            library.load()
        refusals = (NotFoundError, *library.refusals())
        work(addon)
    except refusals as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 2
    return 0


def part(addon: ModuleType, name: str) -> ModuleType:
    """A submodule of the add-on, such as "blender.pipeline"."""
    return importlib.import_module(f"{addon.__name__}.{name}")


def _enable_installed() -> ModuleType | None:
    """As an extension (Blender 4.2 and later) or as an add-on, whether enabled before or not."""
    import addon_utils

    names = [module.__name__ for module in addon_utils.modules()]
    name = next((name for name in names if name.rpartition(".")[2] == ADDON), None)
    return addon_utils.enable(name) if name else None
