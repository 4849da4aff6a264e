# SPDX-License-Identifier: GPL-3.0-or-later
"""Every test has a Blender of its own, with the packaged add-on installed into an empty configuration."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import window


@pytest.fixture(scope="session")
def archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return window.archives.archive_for(window.BLENDER, tmp_path_factory.mktemp("zips"))
