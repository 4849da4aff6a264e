# SPDX-License-Identifier: GPL-3.0-or-later
"""dirichlet_surface with a factor in single precision, refined."""

from pathlib import Path

from ..recorder import Recorder
from ..scene import Scene
from . import ours


def run(scene: Scene, field: Path, recorder: Recorder) -> None:
    try:
        ours.run(scene, field, recorder, "single")
    except TypeError as error:  # no such option
        recorder.state("missing", str(error))
