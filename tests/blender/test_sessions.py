# SPDX-License-Identifier: GPL-3.0-or-later
"""What is kept of a mesh between two solves, and when it is not."""

import importlib

import bmesh
import bpy
import numpy as np
import pytest
from scene import field_of, library_mesh, paint, painted_grid


@pytest.fixture
def sessions(addon):
    module = importlib.import_module(f"{addon.__name__}.blender.mesh.sessions")
    module.forget_all()
    return module


def test_same_faces_keep_the_solver_and_say_what_was_repeated(sessions, pipeline):
    obj = painted_grid(columns=40, rows=30)
    first = pipeline.solve_field(obj).field.report
    paint(obj, "left", [205])
    stroke = pipeline.solve_field(obj).field.report
    assert (first.update, stroke.update) == ("full", "partial")
    assert stroke.seconds["analysis"] == 0
    assert pipeline.solve_field(obj).field.report.update == "nothing"


def test_renamed_mesh_keeps_its_session(sessions):
    obj = painted_grid()
    session = sessions.open_session(obj)
    obj.name = obj.data.name = "Another"
    assert sessions.open_session(obj) is session


def test_moved_vertices_make_another_mesh_and_keep_the_solver(sessions, pipeline):
    obj = painted_grid()
    pipeline.solve_field(obj)
    session, before = sessions.open_session(obj), sessions.open_session(obj).mesh
    obj.data.vertices[40].co.z = 1.0
    assert sessions.open_session(obj) is session
    assert session.mesh is not before
    assert session.mesh.positions[40, 2] == 1.0
    assert pipeline.solve_field(obj).field.report.update == "nothing"


@pytest.mark.parametrize("method", ["flip", "merge"])
def test_edited_faces_are_solved_anew(sessions, pipeline, surface, method):
    obj = painted_grid()
    pipeline.solve_field(obj)
    session = sessions.open_session(obj)
    editor = bmesh.new()
    editor.from_mesh(obj.data)
    if method == "flip":
        bmesh.ops.triangulate(editor, faces=editor.faces)
    else:
        bmesh.ops.dissolve_faces(editor, faces=editor.faces[24:26])
    editor.to_mesh(obj.data)
    editor.free()
    pipeline.solve_field(obj)
    assert sessions.open_session(obj) is not session
    left, right = range(0, 84, 12), range(11, 84, 12)
    expected = surface.solve(library_mesh(surface, obj), [*left, *right], [0] * 7 + [1] * 7).values
    assert np.array_equal(field_of(obj), expected.astype(np.float32))


def test_few_sessions_are_kept_and_none_of_a_mesh_that_is_gone(sessions):
    objects = [painted_grid(name=f"Grid {k}") for k in range(7)]
    for obj in objects:
        sessions.open_session(obj)
    assert len(sessions._sessions) == 4
    for obj in objects[1:]:
        bpy.data.meshes.remove(obj.data)
    sessions.open_session(objects[0])
    assert len(sessions._sessions) == 1


def test_solver_that_could_not_be_made_does_not_spoil_the_session(sessions, surface, pipeline, monkeypatch):
    obj = painted_grid()
    expected = pipeline.solve_field(obj).field.values

    def refuse(*arguments, **options):
        raise surface.SolverError("not enough memory")

    with monkeypatch.context() as broken:
        broken.setattr(surface, "HarmonicSolver", refuse)
        obj.dirichlet.method = "multigrid"
        with pytest.raises(surface.SolverError):
            pipeline.solve_field(obj)
    obj.dirichlet.method = "auto"
    assert np.array_equal(pipeline.solve_field(obj).field.values, expected)


def test_session_that_makes_room_for_others_ends_what_it_computes(sessions, addon):
    painting = importlib.import_module(f"{addon.__name__}.blender.paint.painting")
    obj = painted_grid()
    session, painted = sessions.open_session(obj), painting.combine(obj, painting.read_patches(obj))
    for k in range(5):
        sessions.open_session(painted_grid(name=f"Grid {k}"))
    assert sessions.open_session(obj) is not session
    values, _ = session.paint(painted, {"method": "auto"})
    assert np.isfinite(values).all()
