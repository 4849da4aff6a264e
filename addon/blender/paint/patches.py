# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of an object's list of patches."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from ... import library
from ...language import say
from .. import preferences, settings
from ..held import Held
from ..mesh import groups, sessions
from ..work import Made, Step, Work, run
from . import painting

QUICK = 200_000  # vertices up to which patches are looked at whenever they change


def add(obj: bpy.types.Object, group: str) -> None:
    """A row for the vertex group, selected, with the next value: 0, then one more than the highest."""
    rows = obj.dirichlet.patches
    if not rows:
        preferences.begin(obj.dirichlet)
    value = max((row.value for row in rows), default=-1.0) + 1.0
    row = rows.add()
    row.group, row.value = group, value
    obj.dirichlet.active_patch = len(rows) - 1


def add_group(obj: bpy.types.Object, name: str, vertices: NDArray[np.integer]) -> None:
    """A vertex group of these vertices at weight 1, and its row; the name is made free by a number behind it."""
    add(obj, groups.add_group(obj, name, vertices))
    obj.dirichlet.patches[-1].vertices = len(vertices)


def duplicate(obj: bpy.types.Object) -> None:
    """Puts a copy of the selected row, with a copy of its vertex group, behind it and selects that."""
    rows, row = obj.dirichlet.patches, obj.dirichlet.active_patch
    name = groups.copy_group(obj, rows[row].group)
    copy, original = rows.add(), rows[row]
    settings.copy(original, copy)
    copy.group = name
    rows.move(len(rows) - 1, row + 1)
    obj.dirichlet.active_patch = row + 1
    recheck(obj)


def move(obj: bpy.types.Object, step: int) -> bool:
    """Moves the selected row by `step`; it stays selected. False, and nothing done, at the end of the list."""
    rows, row = obj.dirichlet.patches, obj.dirichlet.active_patch
    if not 0 <= row + step < len(rows):
        return False
    rows.move(row, row + step)
    obj.dirichlet.active_patch = row + step
    return True


def remove(obj: bpy.types.Object) -> None:
    """Removes the selected row, not its vertex group, and selects the one that takes its place."""
    rows, row = obj.dirichlet.patches, obj.dirichlet.active_patch
    rows.remove(row)
    obj.dirichlet.active_patch = max(0, min(row, len(rows) - 1))
    recheck(obj)


def check(obj: bpy.types.Object) -> Work:
    """Puts vertices and problem into the rows; returns Made. Raises what open_session and read_patches raise."""
    held = Held(obj)
    session = yield from sessions.opening(held)
    painted = painting.read_patches(held.find_mesh())
    facts = yield Step(held.name, 0.5, partial(inspect, session.mesh, painted))
    record_facts(held.find_mesh(), painted, facts)
    return Made([], "")


def recheck(obj: bpy.types.Object) -> None:
    """Checks all rows at once, unless the mesh is so large that nobody would wait for it. What cannot be read keeps
    nobody from changing the list: who checks or solves is told."""
    if len(obj.data.vertices) <= QUICK:
        with suppress(library.LibraryMissingError), suppress(*library.refusals()):
            run(check(obj))


def inspect(mesh: Any, painted: Sequence[Any]) -> list[Any]:
    """The library's PatchFacts of its Patches; mesh: its Mesh. For any thread. Cost: 0.1 s for a million vertices."""
    return library.load().inspect_patches(mesh, [patch.vertices for patch in painted])


def record_facts(obj: bpy.types.Object, painted: Sequence[Any], inspected: Sequence[Any]) -> None:
    """Puts vertices and problem into the rows; rows that are off, or were not there when `painted` was read, get none.

    painted: the library's Patch of every enabled patch; inspected: what `inspect` found out about them.
    """
    names = [patch.name for patch in painted]
    facts: dict[str, list[tuple[int, str]]] = {name: [] for name in names}
    for name, fact in zip(names, inspected):
        facts[name].append((fact.vertices, "; ".join(_problems(fact, name, names))))
    for row in obj.dirichlet.patches:
        known = facts.get(row.group) if row.enabled else None
        vertices, problem = known.pop(0) if known else (0, "")
        if (row.vertices, row.problem) != (vertices, problem):  # a write evaluates the object anew
            row.vertices, row.problem = vertices, problem


def _problems(fact: Any, name: str, names: Sequence[str]) -> list[str]:
    """What keeps the patch of that name from being one disc, or one closed line, apart from all others."""
    problems = [say("The vertex group is in the list twice")] if names.count(name) > 1 else []
    if not fact.vertices:
        return [*problems, say("Empty: no weight in the vertex group reaches the threshold")]
    others = ", ".join(repr(names[other]) for other in fact.overlaps if names[other] != name)
    if others:
        problems.append(say("Overlaps {others}", others=others))
    if fact.components > 1:
        return [*problems, say("Not connected: {count} pieces", count=fact.components)]
    return problems + ([] if fact.disc else _why_no_disc(fact))


def _why_no_disc(fact: Any) -> list[str]:
    """Of a connected patch. A closed line without faces, such as a border of the mesh, is as good as a disc."""
    if not fact.faces:
        closed = fact.edges == fact.vertices
        return [] if closed else [say("Not a disc: it covers no face, so the field is steep around it")]
    if not fact.manifold:
        return [say("Not a disc: faces meet in a single vertex, or more than two in an edge")]
    if fact.euler_characteristic + fact.border_loops == 2 and fact.border_loops != 1:
        if not fact.border_loops:
            return [say("Not a disc: it has no border")]
        return [say("Not a disc: {count} borders", count=fact.border_loops)]
    return [say("Not a disc: it has a handle, or edges without a face")]
