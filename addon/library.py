# SPDX-License-Identifier: GPL-3.0-or-later
"""The one place that finds `dirichlet_surface`: the copy in this add-on's folder, else an installed one.

It is imported at first use, so that enabling the add-on and drawing its panel work without it.
"""

from __future__ import annotations

import importlib
import importlib.machinery
import importlib.util
import sys
from pathlib import Path
from types import ModuleType

from .language import say

_NAME = "dirichlet_surface"
_failure: str | None = None  # not known yet


class LibraryMissingError(Exception):
    """The library cannot be imported; the message says why, or what was expected and what was found."""


def load(submodule: str = "") -> ModuleType:
    """The package, or a submodule of it. Raises LibraryMissingError."""
    global _failure
    name = _bundled() if importlib.util.find_spec(_bundled()) else _NAME
    try:
        package = importlib.import_module(name)
        _failure = ""
        return importlib.import_module(f"{name}.{submodule}") if submodule else package
    except ImportError as error:
        _failure = _mismatch(f" ({error})") or say("The compiled library could not be loaded: {reason}", reason=error)
        raise LibraryMissingError(_failure) from error


def failure() -> str:
    """Why there is no library, as far as its last import told, or its files where there was none yet; else nothing."""
    global _failure
    if _failure is None:
        _failure = _mismatch("")
    return _failure


def refusals() -> tuple[type[Exception], ...]:
    """What operators report in a sentence; everything else is a bug of ours and keeps its traceback."""
    return (LibraryMissingError,) if _failure else (LibraryMissingError, load().DirichletError)


def _bundled() -> str:
    return f"{__package__}.{_NAME}"


def _mismatch(reason: str) -> str:
    """Nothing where the library for this Python is, whether it can be loaded or not."""
    spec = importlib.util.find_spec(_bundled()) or importlib.util.find_spec(_NAME)
    places = spec.submodule_search_locations if spec else None
    folders = [Path(place) for place in places or [Path(__file__).parent / _NAME]]
    expected = [f"_native{suffix}" for suffix in importlib.machinery.EXTENSION_SUFFIXES]
    found = sorted(path.name for folder in folders for path in folder.glob("_native*") if path.suffix != ".pyi")
    if any(name in expected for name in found):
        return ""
    return say(
        "The compiled library could not be loaded: expected {expected} for Python {major}.{minor} in {folder}, found "
        "{found}{reason}",
        expected=expected[0],
        major=sys.version_info.major,
        minor=sys.version_info.minor,
        folder=folders[0],
        found=", ".join(found) or say("no compiled module"),
        reason=reason,
    )
