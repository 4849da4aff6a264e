# SPDX-License-Identifier: GPL-3.0-or-later
"""Every work that may take long: dropped at any step it has made nothing, and nothing is computed for nobody."""

from threading import Event

import bpy
import pytest
from refusal import state
from scene import add, painted_grid

# The steps of every work on a mesh that the library does not know yet, and how the add-on begins it.
WORKS = {
    "solve": (2, lambda module, obj: module("several").solve_fields([obj])),
    "lines": (2, lambda module, obj: module("several").make_isolines([obj])),
    "refresh": (2, lambda module, obj: module("several").refresh([obj.dirichlet.isolines])),
    "check": (2, lambda module, obj: module("paint.patches").check(obj)),
    "borders": (2, lambda module, obj: module("paint.patch_sources").from_borders(obj)),
    "pieces": (1, lambda module, obj: module("paint.patch_sources").from_pieces(obj)),
    "attribute": (1, lambda module, obj: module("paint.patch_sources").from_attribute(obj, "islands", False)),
    "disc": (2, lambda module, obj: module("paint.discs").open_disc(obj, (3, 3, 0), 2.0)),
    "level": (2, lambda module, obj: module("lines.level_picking").add_level(obj, (3.3, 3, 0))),
}


@pytest.fixture
def sheet(module):
    """With a field, isolines and an attribute, and nothing of it known to the library."""
    obj = painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    obj.data.attributes.new("islands", "INT", "FACE")
    module("mesh.sessions").forget_all()
    return obj


@pytest.mark.parametrize("name", WORKS)
def test_a_work_dropped_at_any_of_its_steps_has_written_nothing(module, sheet, name):
    steps, begin = WORKS[name]
    before = state(sheet)
    for passed in range(steps):
        module("mesh.sessions").forget_all()
        work = begin(module, sheet)
        step = next(work)
        for _ in range(passed):
            step = work.send(step.compute())
        assert step.name == "Grid"
        assert 0 <= step.part < 1
        work.close()
        assert state(sheet) == before
    module("mesh.sessions").forget_all()
    work = begin(module, sheet)
    step = next(work)
    for _ in range(steps - 1):
        step = work.send(step.compute())
    with pytest.raises(StopIteration):
        work.send(step.compute())


@pytest.mark.parametrize("name", ["solve", "lines", "refresh", "disc"])
def test_what_is_computed_for_a_dropped_work_stops(module, sheet, surface, name):
    work = WORKS[name][1](module, sheet)
    step = work.send(next(work).compute())
    work.close()
    with pytest.raises(surface.CancelledError):
        step.compute()


@pytest.mark.parametrize("name", WORKS)
def test_a_mesh_that_is_edited_meanwhile_is_named_and_left_alone(module, sheet, surface, name):
    work = WORKS[name][1](module, sheet)
    step = next(work)
    sheet.data.vertices[3].co.z = 1.0
    before = state(sheet)
    made = step.compute()
    with pytest.raises(surface.InputError, match="'Grid' changed while it was being worked on"):
        work.send(made)
    assert state(sheet) == before


def test_a_quick_work_is_waited_for(module):
    ready = Event()

    def work():
        yield module("work").Step("somebody", 0.0, ready.wait)
        return "done"

    background = module("work").Background(work())
    assert background.wait(0.02) is None
    ready.set()
    assert background.wait(60) == "done"


def test_several_results_are_refreshed_together_but_no_locked_one(module, sheet):
    results = []
    for _ in range(3):
        bpy.context.view_layer.objects.active = sheet
        bpy.ops.dirichlet.make_isolines()
        results.append(sheet.dirichlet.isolines)
        results[-1].parent = None
    locked, one, active = results
    locked.dirichlet_isolines.locked = True
    for obj in results:
        obj.dirichlet_isolines.count = 4
        obj.select_set(True)
    bpy.context.view_layer.objects.active = active
    assert bpy.ops.dirichlet.result_refresh() == {"FINISHED"}
    assert [len(obj.data.splines) for obj in (locked, one, active)] == [13, 4, 4]


def test_a_result_that_is_removed_meanwhile_is_named(module, sheet, surface):
    work = module("several").refresh([sheet.dirichlet.isolines])
    step = work.send(next(work).compute())
    name = sheet.dirichlet.isolines.name
    bpy.data.objects.remove(sheet.dirichlet.isolines)
    made = step.compute()
    with pytest.raises(surface.InputError, match=f"'{name}' was removed"):
        work.send(made)


def test_a_mesh_that_the_library_refuses_is_refused_in_every_work(module, surface):
    obj = add([(0, 0, 0), (1, 0, 0)], [])
    for name in ("check", "borders", "disc"):
        with pytest.raises(surface.InputError, match="no faces"):
            module("work").run(WORKS[name][1](module, obj))
