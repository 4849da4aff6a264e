# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and lines computed beside the interface, and what may happen to their object meanwhile."""

import importlib
import time
from contextlib import suppress
from threading import current_thread, main_thread
from types import SimpleNamespace

import bpy
import pytest
from refusal import state
from scene import field_of, painted_sphere


@pytest.fixture
def solving(module):
    """Starts to solve for the objects' fields beside the interface."""
    return lambda *objects: module("work").Background(module("several").solve_fields(objects))


@pytest.fixture
def tracing(module):
    return lambda *objects: module("work").Background(module("several").make_isolines(objects))


def finish(background):
    """What it makes in the end."""
    end = time.monotonic() + 60
    while (made := background.poll()) is None:
        assert time.monotonic() < end, "nothing comes of it"
        time.sleep(0.001)
    return made


def test_beside_the_interface_comes_the_same_field_as_at_once(solving):
    beside, at_once = painted_sphere(name="beside"), painted_sphere(name="at once")
    made = finish(solving(beside))
    at_once.select_set(True)
    beside.select_set(False)
    bpy.ops.dirichlet.solve_field()
    assert field_of(beside).tolist() == field_of(at_once).tolist()
    assert beside.dirichlet.results.solved
    assert "vertices solved" in made.summary


def test_steps_are_computed_in_another_thread_and_written_in_the_main_one(module):
    threads = []

    def work():
        threads.append(current_thread())
        threads.append((yield module("work").Step("somebody", 0.0, current_thread)))
        threads.append(current_thread())
        return True

    assert finish(module("work").Background(work()))
    assert (threads[0], threads[2]) == (main_thread(), main_thread())
    assert threads[1] != main_thread()


def test_progress_counts_vertices_and_not_objects(module):
    small, large = painted_sphere(2, name="small"), painted_sphere(4, name="large")
    objects = small, large
    share = len(small.data.vertices) / sum(len(obj.data.vertices) for obj in objects)
    for work in (module("several").solve_fields, module("several").make_isolines):
        told = []
        module("work").run(work(objects), told.append)
        assert told == sorted(told)
        assert told[-1] == pytest.approx(share + 0.3 * (1 - share))


def steps_of(work):
    """What is done one after the other."""
    with suppress(StopIteration):
        step = next(work)
        while True:
            yield step
            step = work.send(step.compute())


def test_every_step_says_what_it_does(module):
    obj, several = painted_sphere(), module("several")
    assert [step.doing for step in steps_of(several.solve_fields([obj]))] == ["connecting the mesh", "solving"]
    module("mesh.sessions").forget_all()
    assert [step.doing for step in steps_of(several.make_isolines([obj]))] == ["connecting the mesh", "tracing lines"]


def test_the_status_bar_names_operator_object_and_step(addon, module):
    computing = importlib.import_module(f"{addon.__name__}.ui.computing")
    shown, told = [], []
    background = SimpleNamespace(step=module("work").Step("Ball", 0.3, int, "solving"))
    operator = SimpleNamespace(_background=background, _begun=time.perf_counter() - 7, bl_label="Solve Field")
    context = SimpleNamespace(
        window_manager=SimpleNamespace(progress_update=told.append),
        workspace=SimpleNamespace(status_text_set=shown.append),
    )
    computing.Computing._show_progress(operator, context)
    assert (told, shown) == ([0.3], ["Solve Field: Ball, solving, 7 s     Esc: Cancel"])


def test_what_is_dropped_has_written_nothing(solving):
    obj = painted_sphere()
    before = state(obj)
    background = solving(obj)
    background.stop()
    assert state(obj) == before


def test_a_solver_that_was_dropped_stops_and_serves_the_next(solving, module, surface):
    obj = painted_sphere(6)
    obj.dirichlet.method = "lscg"
    background = solving(obj)
    while not module("mesh.sessions").open_session(obj).is_busy():
        background.poll()
    background.stop()
    obj.dirichlet.method = "auto"
    bpy.ops.dirichlet.solve_field()
    assert obj.dirichlet.results.solved
    assert background._job.exception(60).__class__ is surface.CancelledError


def test_an_object_that_was_renamed_gets_its_field(solving):
    obj = painted_sphere()
    background = solving(obj)
    obj.name = "another name"
    finish(background)
    assert obj.dirichlet.results.solved


def remove(obj):
    bpy.data.objects.remove(obj)


def edit(obj):
    obj.data.vertices[3].co.x += 1


def enter_edit_mode(obj):
    bpy.ops.object.mode_set(mode="EDIT")


def new_faces(obj):
    obj.data.clear_geometry()


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (remove, "'Sphere' was removed"),
        (edit, "mesh of object 'Sphere' changed"),
        (new_faces, "mesh of object 'Sphere' changed"),
        (enter_edit_mode, "'Sphere' is in Edit Mode"),
    ],
)
def test_an_object_that_is_not_what_it_was_is_named_and_left_alone(change, sentence, solving, tracing, surface):
    for start in (solving, tracing):
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        obj = painted_sphere()
        bpy.ops.dirichlet.solve_field()
        obj.dirichlet.results.solved = False
        background = start(obj)
        change(obj)
        with pytest.raises(surface.InputError, match=sentence):
            finish(background)
        assert not bpy.data.curves
        assert not any(one.dirichlet.results.solved for one in bpy.data.objects)


def test_undo_while_computing_does_no_harm(solving):
    obj = painted_sphere()
    bpy.ops.ed.undo_push(message="painted")
    obj.dirichlet.count = 20
    bpy.ops.ed.undo_push(message="count")
    background = solving(obj)
    bpy.ops.ed.undo()
    finish(background)
    obj = bpy.data.objects["Sphere"]
    assert obj.dirichlet.count == 13
    assert obj.dirichlet.results.solved


def test_closing_the_file_while_computing_does_no_harm(solving, surface):
    background = solving(painted_sphere())
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with pytest.raises(surface.DirichletError, match=r"'Sphere' was removed|cancelled"):
        finish(background)


def test_closing_the_file_stops_what_is_computed_for_it(module, surface):
    obj = painted_sphere()
    session, painting = module("mesh.sessions").open_session(obj), module("paint.painting").read_painting(obj)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with pytest.raises(surface.CancelledError):
        session.paint(painting, {})


def test_without_a_window_invoking_computes_at_once_and_asks_nothing(module, monkeypatch):
    monkeypatch.setattr(module("preferences"), "DEFAULTS", module("preferences").Preferences(ask_vertices=1))
    obj = painted_sphere()
    assert bpy.ops.dirichlet.solve_field("INVOKE_DEFAULT") == {"FINISHED"}
    assert bpy.ops.dirichlet.make_isolines("INVOKE_DEFAULT") == {"FINISHED"}
    assert obj.dirichlet.results.extracted


def test_what_was_asked_about_first_has_its_undo_step():
    painted_sphere()
    bpy.ops.ed.undo_push(message="painted")
    assert bpy.ops.dirichlet.ask_first("EXEC_DEFAULT", True, asking="solve_field") == {"FINISHED"}
    assert "dirichlet_field" in bpy.context.active_object.data.attributes
    bpy.ops.ed.undo()
    assert len(bpy.context.active_object.dirichlet.patches) == 2
    assert "dirichlet_field" not in bpy.context.active_object.data.attributes


@pytest.mark.parametrize(("vertices", "measured"), [(125_316, 1257), (1_000_000, 1392), (4_000_000, 1559)])
def test_expected_memory_is_what_was_measured(module, vertices, measured):
    expected = module("expected_memory").of_field(vertices, "direct", None) / vertices
    assert expected == pytest.approx(measured, rel=0.1)


def test_expected_memory_of_polygons_is_what_was_measured(module):
    of_field = module("expected_memory").of_field
    for corners, measured in ((4, 1244), (6, 1814)):
        assert of_field(125_000, "direct", None, corners) / 125_000 == pytest.approx(measured, rel=0.1)


def test_expected_memory_keeps_to_the_budget_where_the_method_does(module):
    of_field = module("expected_memory").of_field
    assert of_field(10**6, "auto", 10**9) == 10**9
    assert of_field(10**6, "direct", 10**9) > 10**9
    assert of_field(10**7, "auto", 10**9) == of_field(10**7, "multigrid", None)
