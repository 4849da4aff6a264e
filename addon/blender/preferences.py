# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user prefers for every file, from the add-on's preferences."""

from __future__ import annotations

from dataclasses import dataclass

import bpy

from .. import library

PACKAGE = __package__.rpartition(".")[0]  # the add-on's own: it depends on how the add-on was installed


@dataclass(frozen=True)
class Preferences:
    """What holds unless the user says otherwise."""

    ramp: str = "rainbow"
    live_delay: float = 0.1  # seconds, from the last change to its update
    ask_vertices: int = 2_000_000  # more are worth a question first
    threads: int = 0  # 0: one per processor
    memory_budget: int = 0  # megabytes for a factorisation; 0: half of the machine's memory


DEFAULTS = Preferences()


def get() -> Preferences | bpy.types.AddonPreferences:
    """The user's, or the defaults where the add-on is registered without being enabled."""
    addon = bpy.context.preferences.addons.get(PACKAGE)
    return addon.preferences if addon and addon.preferences else DEFAULTS


def memory_budget() -> int | None:
    """Bytes, as the library's solvers take it."""
    return get().memory_budget * 2**20 or None


def limit_threads() -> None:
    """Tells the library how many threads it may use. Raises LibraryMissingError."""
    library.load().set_thread_limit(get().threads or None)


def begin(settings: bpy.types.PropertyGroup) -> None:
    """Gives the settings of an object that begins with its first patch what the user prefers, where nothing was set."""
    if not settings.is_property_set("ramp_preset") and not settings.ramp_stops:
        settings.ramp_preset = get().ramp
