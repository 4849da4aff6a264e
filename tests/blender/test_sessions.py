# SPDX-License-Identifier: GPL-3.0-or-later
"""What is kept of a mesh between two solves, and when it is not."""

import gc
import importlib
import time
import weakref
from threading import Thread

import bmesh
import bpy
import numpy as np
import pytest
from scene import add, field_of, library_mesh, paint, painted_grid


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


def test_moved_vertices_connect_no_faces_again_and_keep_the_solver(sessions, pipeline, surface, monkeypatch):
    obj = painted_grid()
    pipeline.solve_field(obj)
    session, before = sessions.open_session(obj), sessions.open_session(obj).mesh
    monkeypatch.setattr(surface, "Mesh", lambda *_: pytest.fail("faces are connected again"))
    session.deformed(before.positions + 1.0)
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


@pytest.fixture
def budget(module, monkeypatch):
    """Sets the memory budget of the preferences, in megabytes."""
    of = module("preferences")
    return lambda megabytes: monkeypatch.setattr(of, "DEFAULTS", of.Preferences(memory_budget=megabytes))


def test_sessions_keep_to_the_memory_budget_and_the_newest_stays(sessions, pipeline, budget):
    objects = [painted_grid(60, 60, name=f"Grid {k}") for k in range(3)]
    for obj in objects:
        pipeline.solve_field(obj)
    first, second, third = sessions._sessions.values()
    assert first.bytes > 160 * 3600  # more than the connectivity: a factor
    budget(1 + int((second.bytes + third.bytes) / 2**20))
    sessions.open_session(objects[2])
    assert list(sessions._sessions.values()) == [second, third]
    budget(1)
    assert first.bytes + second.bytes > 2**20
    assert sessions.open_session(objects[1]) is second
    assert list(sessions._sessions.values()) == [second]


def test_room_is_made_before_a_factor_is_there(sessions, pipeline, module, budget):
    one, other = painted_grid(60, 60), painted_grid(60, 60, name="Other")
    pipeline.solve_field(one)
    sessions.open_session(other)
    assert len(sessions._sessions) == 2
    budget(5)
    sessions.open_session(other)
    assert len(sessions._sessions) == 2
    other.dirichlet.method = "direct"
    module("field_task").read(other)  # of which 3 MB are expected
    assert list(sessions._sessions) == [other.data.as_pointer()]


def test_a_session_at_work_is_kept_whatever_it_takes(sessions, budget):
    busy = sessions.open_session(painted_grid())
    budget(1)
    with busy._lock:  # as the thread that paints holds it
        for k in range(5):
            sessions.open_session(painted_grid(90, 90, name=f"Grid {k}"))
        assert next(iter(sessions._sessions.values())) is busy
        assert len(sessions._sessions) == 2
    sessions.open_session(painted_grid(name="Last"))
    assert busy not in sessions._sessions.values()


@pytest.fixture
def two_paintings(sessions, module, surface):
    """A session, something to paint in it that takes very long, and the tokens of two who want that."""
    obj = painted_grid(200, 200)
    session = sessions.open_session(obj)
    return session, module("paint.painting").read_painting(obj), surface.CancelToken(), surface.CancelToken()


def painting_in_thread(session, painting, options, stop, told):
    def paint():
        try:
            told.append(np.isfinite(session.paint(painting, options, stop=stop)[0]).all())
        except Exception as error:
            told.append(type(error).__name__)

    thread = Thread(target=paint, daemon=True)
    thread.start()
    return thread


def test_interrupting_who_waits_leaves_the_one_at_work_alone(two_paintings, surface):
    session, painting, mine, other = two_paintings
    told, waiting = [], []
    worker = painting_in_thread(session, painting, {"method": "lscg"}, mine, told)
    while session._current is not mine:
        time.sleep(0.001)
    second = painting_in_thread(session, painting, {"method": "lscg"}, other, waiting)
    session.interrupt(other)
    assert not session._token.is_cancelled
    assert not told
    session.interrupt(mine)
    worker.join(60)
    second.join(60)
    assert (told, waiting) == (["CancelledError"], ["CancelledError"])


def test_after_an_interruption_the_next_painting_is_whole(two_paintings, surface):
    session, painting, mine, other = two_paintings
    session.interrupt(mine)
    with pytest.raises(surface.CancelledError):
        session.paint(painting, {"method": "auto"}, stop=mine)
    assert np.isfinite(session.paint(painting, {"method": "auto"}, stop=other)[0]).all()


def test_a_session_that_is_forgotten_is_gone_also_where_live_painted_on_it(sessions, live):
    obj = painted_grid()
    obj.dirichlet.live = True
    bpy.context.view_layer.update()
    live.flush()
    session = weakref.ref(sessions.open_session(obj))
    for k in range(5):
        sessions.open_session(painted_grid(name=f"Grid {k}"))
    gc.collect()
    assert session() is None


def test_solving_many_objects_holds_no_more_solvers_than_fit(sessions, module, budget):
    objects = [painted_grid(60, 60, name=f"Grid {k}") for k in range(3)]
    for obj in objects:
        obj.dirichlet.method = "direct"
    budget(4)  # 3 MB are expected of each
    held = []

    def count_solvers(done):
        held.append(sum(isinstance(one, sessions.Session) and bool(one._solver) for one in gc.get_objects()))

    module("work").run(module("several").solve_fields(objects), count_solvers)
    assert len(held) == 6
    assert max(held) == 1


@pytest.mark.parametrize(("laplacian", "kept"), [("graph", True), ("polygon", False)])
def test_room_is_made_for_polygons_that_couple_all_their_corners(sessions, module, budget, laplacian, kept):
    one = painted_grid(60, 60)
    sessions.open_session(one)
    circle = [(np.cos(angle), np.sin(angle)) for angle in np.linspace(0, 2 * np.pi, 60, endpoint=False)]
    discs = add(
        [(x, y, k) for k in range(50) for x, y in circle], [range(60 * k, 60 * k + 60) for k in range(50)], name="Discs"
    )
    paint(discs, "one", range(60), 1.0)
    discs.dirichlet.method, discs.dirichlet.laplacian = "direct", laplacian
    budget(5)  # for the graph 2.4 MB are expected, for the polygons 36
    module("field_task").read(discs)
    assert (one.data.as_pointer() in sessions._sessions) is kept
