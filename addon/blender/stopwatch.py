# SPDX-License-Identifier: GPL-3.0-or-later
from __future__ import annotations

from time import perf_counter


class Stopwatch:
    """Seconds of successive stages."""

    def __init__(self) -> None:
        self.laps: dict[str, float] = {}
        self.restart()

    def lap(self, name: str) -> None:
        """The time since the last lap or restart was spent on this."""
        now = perf_counter()
        self.laps[name] = self.laps.get(name, 0.0) + now - self._last
        self._last = now

    def restart(self) -> None:
        """The time since the last lap was nobody's."""
        self._last = perf_counter()
