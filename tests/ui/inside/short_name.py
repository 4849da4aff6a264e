# SPDX-License-Identifier: GPL-3.0-or-later
"""Importing this gives the installed add-on the name `dirichlet_isolines`, which as an extension it has only at the end
of a longer one."""

import sys

for name in [*sys.modules]:
    repository, short, inner = name.partition("dirichlet_isolines")
    if repository.startswith("bl_ext."):
        sys.modules[short + inner] = sys.modules[name]

import dirichlet_isolines  # noqa: E402
from dirichlet_isolines import library  # noqa: E402

dirichlet_isolines.dirichlet_surface = library.load()  # which an extension has beside it
