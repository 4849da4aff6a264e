# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs on the surface as patches, and the rays that find their middle."""

import importlib
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from refusal import assert_refused, state
from scene import grid, painted_grid, painted_sphere


@pytest.fixture
def picking(addon):
    return importlib.import_module(f"{addon.__name__}.blender.mesh.picking")


@pytest.fixture
def discs(addon):
    return importlib.import_module(f"{addon.__name__}.blender.paint.discs")


def disc(*how, location=(5.0, 3.0, 0.0), radius=1.5, **more):
    return bpy.ops.dirichlet.add_patch_disc(*how, location=location, radius=radius, **more)


def members(obj, name):
    index = obj.vertex_groups[name].index
    return {v.index for v in obj.data.vertices for g in v.groups if g.group == index and g.weight == 1}


def near(obj, location, radius):
    return {v.index for v in obj.data.vertices if (v.co - Vector(location)).length <= radius}


def positions(obj):
    return np.array([vertex.co for vertex in obj.data.vertices])


@pytest.mark.parametrize("mode", ["OBJECT", "WEIGHT_PAINT", "VERTEX_PAINT"])
def test_a_disc_on_a_plane_is_a_disc_and_has_the_next_value(mode):
    obj = painted_grid()
    bpy.ops.object.mode_set(mode=mode)
    disc(radius=2.2)
    assert obj.mode == mode
    patch = obj.dirichlet.patches[2]
    assert members(obj, patch.group) == near(obj, (5, 3, 0), 2.2)
    assert (patch.value, patch.vertices, obj.dirichlet.active_patch) == (2, len(members(obj, patch.group)), 2)
    assert obj.vertex_groups.active.name == patch.group


def test_a_disc_follows_the_surface_and_not_the_space():
    obj = grid(40, 3)
    around = positions(obj)
    angle = around[:, 0] / 40 * 2 * np.pi * 0.98  # nearly a closed tube: its two ends almost touch
    around[:, 0], around[:, 2] = 6 * np.cos(angle), 6 * np.sin(angle)
    obj.data.vertices.foreach_set("co", around.ravel())
    disc(location=around[40], radius=3)
    assert {vertex % 40 for vertex in members(obj, "Disc")} == {0, 1, 2, 3}


def test_the_middle_and_radius_are_in_object_space():
    obj = painted_grid()
    obj.matrix_world = Matrix.Translation((9, 9, 9)) @ Matrix.Rotation(1, 4, "X") @ Matrix.Diagonal((3, 3, 3, 1))
    disc()
    assert members(obj, "Disc") == near(obj, (5, 3, 0), 1.5)


def test_the_field_takes_the_value_on_the_disc():
    obj = painted_sphere(4)
    disc(location=(1, 0, 0), radius=0.3)
    obj.dirichlet.patches[2].value = 4.0
    bpy.ops.dirichlet.solve_field()
    values = np.array([item.value for item in obj.data.attributes["dirichlet_field"].data])
    assert set(np.flatnonzero(values == 4)) == members(obj, "Disc")
    assert obj.dirichlet.patches[2].problem == ""


def test_the_radius_is_remembered():
    obj = painted_grid()
    disc(radius=2.0)
    assert obj.dirichlet.disc_radius == pytest.approx(2)
    bpy.ops.dirichlet.add_patch_disc(location=(3, 3, 0))
    assert members(obj, "Disc.001") == near(obj, (3, 3, 0), 2.0)
    other = painted_grid(columns=23, rows=13, name="Other")  # as far as settings are copied, it is a part of the box
    other.dirichlet.disc_size = obj.dirichlet.disc_size
    assert other.dirichlet.disc_radius == pytest.approx(4)


@pytest.mark.parametrize(("system", "scale", "said"), [("METRIC", 0.01, "radius 2 cm"), ("NONE", 1, "radius 2\n")])
def test_the_radius_is_said_in_the_units_of_the_scene(capfd, system, scale, said):
    units = bpy.context.scene.unit_settings
    units.system, units.scale_length = system, scale
    painted_grid()
    disc(radius=2.0)
    assert said in capfd.readouterr().out


def test_adding_a_disc_is_one_undo_step():
    obj = painted_grid()
    bpy.ops.ed.undo_push(message="painted")
    before = state(obj)
    disc("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    obj = bpy.data.objects["Grid"]
    assert state(obj)["groups"] == before["groups"]
    assert state(obj)["settings"] == before["settings"]
    bpy.ops.ed.redo()
    obj = bpy.data.objects["Grid"]
    assert members(obj, "Disc") == near(obj, (5, 3, 0), 1.5)


def test_a_disc_too_small_for_the_mesh_is_refused():
    obj = painted_grid()
    assert_refused(
        lambda *how: disc(*how, location=(5.5, 3.5, 0), radius=0.5), obj, "no vertex of 'Grid' is within 0.5"
    )


def test_edit_mode_is_left_first():
    painted_grid()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="mode first"):
        disc()


def test_a_shared_mesh_gets_the_group_once_and_only_this_object_the_patch():
    obj = painted_grid()
    other = bpy.data.objects.new("Other", obj.data)
    bpy.context.collection.objects.link(other)
    disc()
    assert [group.name for group in obj.vertex_groups] == ["left", "right", "Disc"]
    assert len(other.dirichlet.patches) == 0


def test_a_linked_mesh_is_left_alone(tmp_path):
    painted_grid()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "source.blend"))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with bpy.data.libraries.load(str(tmp_path / "source.blend"), link=True) as (_, taken):
        taken.objects = ["Grid"]
    bpy.context.collection.objects.link(taken.objects[0])
    bpy.context.view_layer.objects.active = taken.objects[0]
    with pytest.raises(RuntimeError, match="linked from another file"):
        disc()


def cast(picking, obj, origin, direction):
    depsgraph = bpy.context.evaluated_depsgraph_get()
    return picking.cast_ray(obj, depsgraph, Vector(origin), Vector(direction))


def test_a_ray_in_world_space_finds_the_place_on_the_mesh(picking):
    obj = grid()
    obj.matrix_world = Matrix.Translation((0, 0, 7)) @ Matrix.Rotation(np.pi / 2, 4, "X") @ Matrix.Scale(2, 4)
    hit = cast(picking, obj, (5, -99, 14), (0, 1, 0))
    assert tuple(hit.location) == pytest.approx((2.5, 3.5, 0), abs=1e-4)
    assert tuple(hit.shown) == pytest.approx((5, 0, 14), abs=1e-4)
    assert hit.face == 2 + 3 * 11
    assert cast(picking, obj, (5, -99, 14), (0, -1, 0)) is None
    assert cast(picking, obj, (-5, -99, 14), (0, 1, 0)) is None


def pose(obj):
    """A shape key that shows the grid three times as wide, five above itself."""
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Moved")
    for point in key.data:
        point.co = (3 * point.co.x, point.co.y, 5)
    key.value = 1


def test_on_a_deformed_surface_the_place_is_that_of_the_mesh_below(picking):
    obj = grid()
    pose(obj)
    hit = cast(picking, obj, (7.5, 2.5, 99), (0, 0, -1))
    assert tuple(hit.location) == pytest.approx((2.5, 2.5, 0), abs=1e-5)
    assert tuple(hit.shown) == pytest.approx((7.5, 2.5, 5), abs=1e-5)


def test_where_modifiers_make_other_faces_the_place_is_as_shown(picking):
    obj = grid()
    obj.modifiers.new("Subdivision", "SUBSURF")
    hit = cast(picking, obj, (2.4, 3.4, 99), (0, 0, -1))
    assert hit.face is None
    assert tuple(hit.location) == pytest.approx((2.4, 3.4, 0), abs=1e-5)


@pytest.mark.parametrize("how", ["hide_viewport", "hide_set", "unlinked", "no faces"])
def test_what_is_not_shown_is_not_hit(picking, how):
    obj = grid()
    if how == "unlinked":
        bpy.context.collection.objects.unlink(obj)
    elif how == "no faces":
        obj.data.clear_geometry()
    elif how == "hide_set":
        obj.hide_set(True)
    else:
        obj.hide_viewport = True
    bpy.context.view_layer.update()
    assert cast(picking, obj, (5.5, 3.5, 99), (0, 0, -1)) is None


def test_the_outline_is_where_the_distance_is_the_radius(discs):
    obj = grid(30, 30)
    shape = discs.run(discs.open_disc(obj, (14.3, 15.2, 0), 6.0))
    lines, colors = shape.outline()
    distances = np.linalg.norm(lines.points - (14.3, 15.2, 0), axis=1)
    assert len(lines) == len(colors) == 1
    assert lines.closed[0]
    assert np.abs(distances - 6).max() < 0.1
    assert len(shape.vertices) == len(near(obj, (14.3, 15.2, 0), 6))


def test_on_a_deformed_surface_the_outline_is_shown_where_the_surface_is(discs):
    obj = grid(30, 30)
    pose(obj)
    shape = discs.run(discs.open_disc(obj, (14, 15, 0), 6.0))
    points = shape.outline()[0].points / (3, 1, 1)
    assert np.abs(np.linalg.norm(points - (14, 15, 5), axis=1) - 6).max() < 0.1
    assert shape.vertices.tolist() == sorted(near(obj, (14, 15, 0), 6))


def test_a_disc_that_is_refused_while_dragged_ends_the_operator(surface):
    def refuse(*_):
        raise surface.InputError("no")

    seen = []
    running = SimpleNamespace(
        _background=None,
        _pointer=SimpleNamespace(move=lambda event: None),
        _released=False,
        _drag=refuse,
        cancel=lambda context: seen.append("end"),
        report=lambda *told: seen.append(told),
    )
    event = SimpleNamespace(type="MOUSEMOVE", value="NOTHING")
    assert bpy.types.DIRICHLET_OT_add_patch_disc.modal(running, bpy.context, event) == {"CANCELLED"}
    assert seen == [({"ERROR"}, "no"), "end"]


def test_a_disc_that_cannot_be_shown_at_once_ends_the_operator(addon, monkeypatch):
    operators = importlib.import_module(f"{addon.__name__}.ui.patches.add_patch_operator")
    pointer = SimpleNamespace(place=(0, 0), hit=lambda context: "hit")
    monkeypatch.setattr(operators, "Pointer", lambda *_: pointer)
    seen = []

    def refuse_to_show(context, objects):
        running._disc = "disc"  # by then the outline is drawn
        return {"CANCELLED"}

    running = SimpleNamespace(
        _disc=None, start=refuse_to_show, choose=lambda context: [], _end=lambda: seen.append("end")
    )
    context = SimpleNamespace(
        area=None,
        region=SimpleNamespace(type="WINDOW"),
        window_manager=SimpleNamespace(modal_handler_add=lambda operator: seen.append("goes on")),
    )
    assert bpy.types.DIRICHLET_OT_add_patch_disc.invoke(running, context, None) == {"CANCELLED"}
    assert seen == ["end"]


def test_a_disc_not_added_leaves_nothing(discs):
    obj = painted_grid()
    before = state(obj)
    shape = discs.run(discs.open_disc(obj, (5, 3, 0), 3.0))
    shape.outline()
    assert state(obj) == before


def test_the_tool_is_in_the_toolbar_of_both_modes():
    from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active as toolbar

    for mode in ("OBJECT", "PAINT_WEIGHT"):
        names = [tool.idname for tool in toolbar._tools_flatten(toolbar._tools[mode]) if tool]
        assert names.count("dirichlet.add_patch") == 1
