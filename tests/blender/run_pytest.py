# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs pytest inside Blender and passes its exit code on.

blender --background --factory-startup --python-exit-code 1 --python tests/blender/run_pytest.py -- [pytest's arguments]
"""

import sys
from pathlib import Path

import pytest

here = Path(__file__).resolve().parent
arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
if not any(Path(argument.partition("::")[0]).exists() for argument in arguments):
    arguments.append(str(here))
sys.exit(pytest.main(["--rootdir", str(here.parents[1]), *arguments]))
