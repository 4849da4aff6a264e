# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a script of steps inside a Blender of its own, in a window on a screen that nobody sees (Xvfb).

    python3 tests/ui/window.py soak --minutes 30      # inside/soak.py, with the add-on's zip installed

Screen, keyboard and mouse are real to Blender; drawing is done by software.
"""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent / "blender"))
import archives  # noqa: E402
import configuration  # noqa: E402

BLENDER = os.environ.get("BLENDER", shutil.which("blender") or "/usr/bin/blender")
OUT = ROOT / "build" / "ui"
SIZES = {"soak": (800, 600)}  # many steps: the fewer the pixels, the more of them
USUAL_SIZE = (1600, 900)


class WindowError(AssertionError):
    """A step failed, or Blender crashed or hung: says in which step, where the picture is, and how the log ended."""


@contextmanager
def screen(width: int, height: int) -> Iterator[str]:
    """The name of a display of so many pixels, which lasts as long as the context."""
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as number:
            yield f":{number.readline().strip()}"
    finally:
        server.terminate()
        server.wait()


def run_inside(script: str, *words: str, archive: Path, limit: float) -> str:
    """The log of inside/SCRIPT.py run with `words`, once all of its steps have passed.

    Pictures and log land in build/ui/SCRIPT. Raises WindowError, also after `limit` seconds.
    """
    folder = OUT / script
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    log = folder / "log.txt"
    size = SIZES.get(script, USUAL_SIZE)
    with tempfile.TemporaryDirectory() as home, screen(*size) as display, log.open("w") as output:
        environment = configuration.empty(Path(home)) | {"LIBGL_ALWAYS_SOFTWARE": "1", "DISPLAY": display}
        configuration.install(BLENDER, environment, archive)
        places = [str(HERE / "inside"), str(HERE.parent / "blender")]
        start = f"import sys; sys.path[:0] = {places}; import short_name, {script}"
        command = [BLENDER, "-noaudio", "--window-geometry", "0", "0", *map(str, size), "--python-expr", start]
        command += ["--", str(folder), *words]
        with subprocess.Popen(command, stdout=output, stderr=output, env=environment) as process:
            ending = _wait(process, limit)
    text = log.read_text()
    if ending or "Traceback (most recent call last)" in text or "UI PASSED" not in text:
        raise WindowError(_explain(text, ending or "a step failed", folder))
    return text


def _wait(process: subprocess.Popen, limit: float) -> str:
    """What was wrong with the end of the process, or nothing."""
    try:
        process.wait(limit)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGUSR1)  # the steps answer with where Python is
        time.sleep(1)
        return f"Blender hung: {limit:g} s were over"
    finally:
        process.kill()
    usual = (0, 1)  # 1 once Esc has been pressed, whatever for; a step that fails says so in the log
    return f"Blender ended with {process.returncode}" if process.returncode not in usual else ""


def _explain(text: str, what: str, folder: Path) -> str:
    steps = re.findall(r"^UI STEP (.*)$", text, re.MULTILINE)
    tail = "\n".join(text.splitlines()[-40:])
    pictures = ", ".join(path.name for path in sorted(folder.glob("*.png"))) or "no pictures"
    return f"step '{steps[-1] if steps else 'start'}': {what}\n{folder}: {pictures}\n{tail}"


if __name__ == "__main__":
    print(run_inside(sys.argv[1], *sys.argv[2:], archive=archives.archive_for(BLENDER, OUT), limit=2 * 3600))
