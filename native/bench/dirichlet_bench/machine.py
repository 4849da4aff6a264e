# SPDX-License-Identifier: GPL-3.0-or-later
"""Where and when the figures were made."""

import os
import platform
import re
import subprocess
from datetime import UTC, datetime
from pathlib import Path

from .contest import CORES, ROOT


def describe() -> dict[str, str | int | float]:
    processor = re.search(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return {
        "processor": processor[1] if processor else platform.machine(),
        "cores": CORES,
        "memory_gb": round(memory, 1),
        "system": platform.freedesktop_os_release().get("PRETTY_NAME", platform.system()),
        **moment(),
    }


def moment() -> dict[str, str | float]:
    """What changes from run to run."""
    date = datetime.now(UTC).isoformat(timespec="seconds")
    return {"commit": commit(), "date": date, "load_before": os.getloadavg()[0]}


def commit() -> str:
    words = ["git", "-C", str(ROOT), "describe", "--always", "--dirty", "--abbrev=12"]
    try:
        return subprocess.run(words, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
