# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by the Python that a wheel was installed for: is everything there, and does it work?"""

import importlib.metadata
import subprocess
import sys
import sysconfig
from pathlib import Path

import dirichlet_surface as ds
import numpy as np

NAME = "dirichlet-surface"

folder = Path(ds.__file__).parent
assert folder.parent == Path(sysconfig.get_path("platlib")), folder
assert (folder / "py.typed").exists()
assert (folder / "_native.pyi").exists()
files = [str(path) for path in importlib.metadata.files(NAME)]
assert any(path.endswith("LICENSE") for path in files), files
for library in ("OpenMesh", "Eigen", "pybind11"):
    assert f"dirichlet_surface/licenses/{library}.txt" in files, files
assert not any(path.startswith("numpy") for path in files), files
assert importlib.metadata.version(NAME) == ds.build_information()["version"]

field = ds.solve(
    ds.Mesh(np.vstack((np.zeros(3), np.eye(3))), [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]), [0, 3], [0, 1]
)
assert np.allclose(field.values, [0, 0.5, 0.5, 1]), field.values

Path("corner.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
command = Path(sys.executable).parent / "dirichlet-surface"
words = [
    "corner.obj",
    "--patch",
    "a=0@0,0,0,0.1",
    "--patch",
    "b=1@1,0,0,0.1",
    "--isolines",
    "3",
    "--out-lines",
    "out.svg",
]
printed = subprocess.run([command, *words], check=True, capture_output=True, text=True).stdout
assert "3 on 3 levels" in printed, printed
assert Path("out.svg").stat().st_size > 0
print(f"{NAME} {importlib.metadata.version(NAME)} works in Python {sys.version.split()[0]} with NumPy {np.__version__}")
