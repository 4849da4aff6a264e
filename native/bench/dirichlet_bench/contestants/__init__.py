# SPDX-License-Identifier: GPL-3.0-or-later
"""One module for each library that is called from Python: run(scene, field, recorder); ours has variants."""
