# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m dirichlet_bench.contestant NAME SCENE FIELD RUNS SECONDS: one library in a process of its own.

NAME is one of contestants/, or name:variant. It prints what it measured; its field of the first painting goes into the
file FIELD.
"""

import importlib
import sys
from pathlib import Path

from .recorder import Recorder
from .scene import load


def main(name: str, scene_folder: str, field: str, runs: str, seconds: str) -> None:
    recorder = Recorder(int(runs), float(seconds))
    name, *variant = name.split(":")
    try:
        contestant = importlib.import_module(f"{__package__}.contestants.{name}")
    except ImportError as error:
        recorder.state("missing", str(error))
    else:
        contestant.run(load(Path(scene_folder)), Path(field), recorder, *variant)


if __name__ == "__main__":
    main(*sys.argv[1:])
