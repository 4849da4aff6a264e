# SPDX-License-Identifier: GPL-3.0-or-later
"""Ours beside other libraries: same meshes, same paint, one run. `./run bench` starts it."""
