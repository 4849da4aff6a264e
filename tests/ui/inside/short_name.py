# SPDX-License-Identifier: GPL-3.0-or-later
"""Importing this gives the installed add-on the name `dirichlet_isolines`, which as an extension it has only at the end
of a longer one."""

import importlib
import pkgutil
import sys

for addon in [name for name in sys.modules if name.startswith("bl_ext.") and name.endswith(".dirichlet_isolines")]:
    inner = [module.name for module in pkgutil.walk_packages(sys.modules[addon].__path__, f"{addon}.")]
    for name in (addon, *inner):  # all, since one imported by the short name first would be another
        sys.modules["dirichlet_isolines" + name.removeprefix(addon)] = importlib.import_module(name)

import dirichlet_isolines  # noqa: E402
from dirichlet_isolines import library  # noqa: E402

dirichlet_isolines.dirichlet_surface = library.load()  # which an extension has beside it
