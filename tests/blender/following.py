# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows, and how to tell that it does."""

import bpy
import numpy as np
from scene import field_of, library_mesh


def settle(live):
    bpy.context.view_layer.update()
    live.flush()


def set_delay(live, monkeypatch, seconds):
    monkeypatch.setattr(live.preferences, "DEFAULTS", live.preferences.Preferences(live_delay=seconds))


def weights(obj, group):
    index = obj.vertex_groups[group].index
    found = {v.index: g.weight for v in obj.data.vertices for g in v.groups if g.group == index}
    return [vertex for vertex, weight in found.items() if weight >= 0.5]


def fresh_field(surface, obj):
    """Solved by the library alone, from the weights as they are."""
    painted = {}
    for patch in obj.dirichlet.patches:
        if patch.enabled:
            painted |= dict.fromkeys(weights(obj, patch.group), patch.value)
    values = surface.solve(library_mesh(surface, obj), list(painted), list(painted.values())).values
    return values.astype(np.float32)


def assert_current(surface, obj):
    assert np.array_equal(field_of(obj), fresh_field(surface, obj))
