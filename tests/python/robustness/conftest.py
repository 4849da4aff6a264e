# SPDX-License-Identifier: GPL-3.0-or-later
import os
from collections.abc import Callable, Iterator

import pytest
from outcomes import Command


@pytest.fixture
def command(tmp_path, monkeypatch, capfd) -> Command:
    monkeypatch.chdir(tmp_path)
    return Command(capfd)


@pytest.fixture
def obey_permissions(tmp_path) -> Iterator[Callable[[], None]]:
    """To be called when files and folders are as they should be: from then on permissions count for root as well."""
    tmp_path.chmod(0o755)
    root = os.geteuid() == 0
    yield lambda: os.seteuid(65534) if root else None
    if root:
        os.seteuid(0)
    tmp_path.chmod(0o755)
