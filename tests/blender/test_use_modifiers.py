# SPDX-License-Identifier: GPL-3.0-or-later
"""Use Modifiers: weights and shape are those of the evaluated mesh, which has to keep the faces that are painted."""

import importlib

import bpy
import numpy as np
import pytest
from refusal import assert_refused
from scene import field_of, paint, painted_grid
from shapes import add_wave, points, points_on_shape


def test_isolines_lie_on_the_evaluated_mesh(surface):
    obj = painted_grid(columns=9)
    obj.dirichlet.use_modifiers = True
    add_wave(obj)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    assert np.ptp(points(obj.dirichlet.isolines)[:, 1]) > 0
    assert np.allclose(points(obj.dirichlet.isolines), points_on_shape(surface, obj), atol=1e-5)


def test_weights_are_those_that_modifiers_leave():
    obj = painted_grid(columns=9)
    modifier = obj.modifiers.new("Half", "VERTEX_WEIGHT_EDIT")
    modifier.vertex_group, modifier.falloff_type = "right", "LINEAR"
    modifier.use_remove, modifier.remove_threshold = True, 1.0
    modifier.mask_constant = 1.0
    obj.vertex_groups["right"].add([8], 0.6, "REPLACE")
    bpy.ops.dirichlet.solve_field()
    assert field_of(obj)[8] == 1
    obj.dirichlet.use_modifiers = True
    bpy.ops.dirichlet.solve_field()
    assert field_of(obj)[8] < 1
    assert not [mesh.name for mesh in bpy.data.meshes if mesh != obj.data]


@pytest.mark.parametrize("operator", ["solve_field", "make_isolines"])
def test_other_faces_are_refused_with_both_counts(operator):
    obj = painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    obj.dirichlet.use_modifiers = True
    sentence = "modifiers of object 'Grid' make 221 vertices and 192 faces of the 63 vertices and 48 faces"
    assert_refused(getattr(bpy.ops.dirichlet, operator), obj, sentence)


def test_live_says_so_too(addon):
    live = importlib.import_module(f"{addon.__name__}.blender.live")
    obj = painted_grid(columns=9)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    obj.dirichlet.live, obj.dirichlet.use_modifiers = True, True
    paint(obj, "left", [12])
    bpy.context.view_layer.update()
    live.flush()
    assert "221 vertices" in obj.dirichlet.results.problem
