# SPDX-License-Identifier: GPL-3.0-or-later
"""The one place that finds `dirichlet_surface`: the copy in this add-on's folder, else an installed one.

It is imported at first use, so that enabling the add-on and drawing its panel work without it.
"""

from __future__ import annotations

import importlib
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

from .language import say

_NAME = "dirichlet_surface"
_failure = ""


class LibraryMissingError(Exception):
    """The library cannot be imported; the message says why, or what was expected and what was found."""


def load(submodule: str = "") -> ModuleType:
    """The package, or a submodule of it. Raises LibraryMissingError."""
    global _failure
    bundled = f"{__package__}.{_NAME}"
    name = bundled if importlib.util.find_spec(bundled) else _NAME
    try:
        package = importlib.import_module(name)
        _failure = ""
        return importlib.import_module(f"{name}.{submodule}") if submodule else package
    except ImportError as error:
        _failure = _explain(error)
        raise LibraryMissingError(_failure) from error


def failure() -> str:
    """The sentence of the last import when that failed, else nothing: for the panel."""
    return _failure


def refusals() -> tuple[type[Exception], ...]:
    """What operators report in a sentence; everything else is a bug of ours and keeps its traceback."""
    return (LibraryMissingError,) if _failure else (LibraryMissingError, load().DirichletError)


def _explain(error: ImportError) -> str:
    import sysconfig

    folder = Path(__file__).parent / _NAME
    expected = f"_native{sysconfig.get_config_var('EXT_SUFFIX')}"
    names = sorted(path.name for path in folder.glob("_native*"))
    if expected in names:
        return say("The compiled library could not be loaded: {reason}", reason=error)
    return say(
        "The compiled library could not be loaded: expected {expected} for Python {major}.{minor} in {folder}, found "
        "{found} ({reason})",
        expected=expected,
        major=sys.version_info.major,
        minor=sys.version_info.minor,
        folder=folder,
        found=", ".join(names) or say("no compiled module"),
        reason=error,
    )
