# SPDX-License-Identifier: GPL-3.0-or-later
"""What panels draw, for a layout that writes it down."""

from types import SimpleNamespace

import bpy
import pytest


class Layout:
    """Takes everything that a panel asks of it, and remembers the operators and properties."""

    def __init__(self):
        self.drawn = []

    def operator(self, name, **_):
        self.drawn.append(name)
        return SimpleNamespace()

    def prop(self, _, name, **__):
        self.drawn.append(name)

    def __getattr__(self, _):
        return lambda **__: self


def drawn(panel):
    layout = Layout()
    getattr(bpy.types, panel).draw(SimpleNamespace(layout=layout), bpy.context)
    return layout.drawn


@pytest.fixture
def result(sheet):
    bpy.ops.dirichlet.make_isolines()
    return sheet.dirichlet.isolines


@pytest.mark.parametrize("bound", [True, False])
def test_levels_are_picked_on_the_mesh_object_alone(result, bound):
    assert "dirichlet.pick_level" in drawn("DIRICHLET_PT_isolines")
    if not bound:
        result.parent = None
    bpy.context.view_layer.objects.active = result
    shown = drawn("DIRICHLET_PT_result_sidebar")
    assert "levels_mode" in shown
    assert "dirichlet.pick_level" not in shown


def test_a_result_that_the_user_deleted_has_no_switches(result):
    assert {"follow", "locked"} < set(drawn("DIRICHLET_PT_isolines"))
    bpy.ops.object.select_all(action="DESELECT")
    result.select_set(True)
    bpy.ops.object.delete()
    assert not {"follow", "locked"} & set(drawn("DIRICHLET_PT_isolines"))
