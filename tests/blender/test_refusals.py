# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be done is said in one sentence that names it, and leaves the scene and the undo history as they were."""

import math

import bpy
import pytest
from refusal import assert_refused
from scene import add, grid, paint, painted_grid, select


def no_patch(obj):
    obj.dirichlet.patches.clear()


def every_patch_off(obj):
    for patch in obj.dirichlet.patches:
        patch.enabled = False


def group_deleted(obj):
    obj.vertex_groups.remove(obj.vertex_groups["left"])


def group_renamed(obj):
    obj.vertex_groups["right"].name = "east"


def patch_without_group(obj):
    obj.dirichlet.patches.add()


def groups_empty(obj):
    for group in obj.vertex_groups:
        group.remove(range(len(obj.data.vertices)))


def below_threshold(obj):
    for name in ("left", "right"):
        paint(obj, name, range(len(obj.data.vertices)), weight=0.4)


def coordinate_nan(obj):
    obj.data.vertices[17].co.x = math.nan


def coordinate_infinite(obj):
    coordinates = [value for vertex in obj.data.vertices for value in vertex.co]
    coordinates[17 * 3] = math.inf
    obj.data.vertices.foreach_set("co", coordinates)


def weight_nan(obj):
    paint(obj, "left", [23, 24, 25], weight=math.nan)


def groups_disagree(obj):
    paint(obj, "right", [0, 12])


def value_nan(obj):
    obj.dirichlet.patches[0].value = math.nan


def vertex_group_named_like_the_field(obj):
    obj.vertex_groups.new(name="dirichlet_field")


def vertex_group_named_like_the_colors(obj):
    obj.vertex_groups.new(name="dirichlet_color")


def attribute_of_another_type(obj):
    obj.data.attributes.new("dirichlet_field", "INT", "EDGE")


def uv_map_named_like_the_field(obj):
    obj.data.uv_layers.new(name="dirichlet_field")


def face_repeats_a_vertex(obj):
    obj.data.loops[1].vertex_index = obj.data.loops[3].vertex_index


BREAKS = {
    no_patch: "Add a patch first",
    every_patch_off: "Add a patch first",
    group_deleted: "no vertex group 'left'",
    group_renamed: "no vertex group 'right'",
    patch_without_group: "no vertex group ''",
    groups_empty: "'left', 'right' have no vertices",
    below_threshold: "'left', 'right' have no vertices",
    coordinate_nan: "vertex 17",
    coordinate_infinite: "vertex 17",
    weight_nan: r"'left': the weight of vertex 23 \(and 2 more\) is not a number",
    groups_disagree: r"vertex 0 is in 'left' with value 0 and in 'right' with value 1 \(and 1 more vertex\)",
    value_nan: "'left'.* nan ",
    vertex_group_named_like_the_field: "'dirichlet_field' of mesh 'Grid' is a vertex group",
    vertex_group_named_like_the_colors: "'dirichlet_color' of mesh 'Grid' is a vertex group",
    attribute_of_another_type: "'dirichlet_field' of mesh 'Grid' is a INT attribute per EDGE",
    uv_map_named_like_the_field: "'dirichlet_field' of mesh 'Grid' is a UV map",
    face_repeats_a_vertex: "face 0",
}


@pytest.mark.parametrize("broken", BREAKS, ids=lambda broken: broken.__name__)
def test_solve_field_refuses(broken):
    obj = painted_grid()
    broken(obj)
    assert_refused(bpy.ops.dirichlet.solve_field, obj, BREAKS[broken])


@pytest.mark.parametrize("broken", [group_deleted, groups_disagree, coordinate_nan], ids=lambda broken: broken.__name__)
def test_solve_field_refuses_after_a_good_solve(broken):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    broken(obj)
    assert_refused(bpy.ops.dirichlet.solve_field, obj, BREAKS[broken])


def test_solve_field_refuses_a_mesh_without_faces():
    obj = add([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [])
    paint(obj, "a", [0])
    assert_refused(bpy.ops.dirichlet.solve_field, obj, "face")


def test_solve_field_refuses_an_empty_mesh():
    obj = add([], [])
    obj.vertex_groups.new(name="a")
    obj.dirichlet.patches.add().group = "a"
    assert_refused(bpy.ops.dirichlet.solve_field, obj, "face|vert")


def test_group_empty_among_others_is_a_warning_naming_it(pipeline):
    obj = painted_grid()
    paint(obj, "nothing", [])
    assert any("'nothing'" in warning for warning in pipeline.solve_field(obj).warnings)


@pytest.mark.parametrize("name", ["solve_field", "make_isolines", "update_colors"])
def test_edit_mode_is_refused_by_the_poll(name):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="Go to Object, Weight Paint or Vertex Paint mode first"):
        getattr(bpy.ops.dirichlet, name)()
    assert obj.mode == "EDIT"


@pytest.mark.parametrize("name", ["solve_field", "make_isolines", "patch_add_selected", "patch_add_group"])
def test_without_a_mesh_the_poll_says_what_to_select(name):
    bpy.ops.object.empty_add()
    with pytest.raises(RuntimeError, match="Select a mesh object first"):
        getattr(bpy.ops.dirichlet, name)()


def test_linked_object_is_refused_by_the_poll(tmp_path):
    painted_grid()
    library = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=library)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with bpy.data.libraries.load(library, link=True) as (_, wanted):
        wanted.objects = ["Grid"]
    bpy.context.collection.objects.link(wanted.objects[0])
    bpy.context.view_layer.objects.active = wanted.objects[0]
    with pytest.raises(RuntimeError, match="make it and its data local first"):
        bpy.ops.dirichlet.solve_field()


def test_add_from_selected_refuses_without_selection():
    obj = grid()
    select(obj, ())
    assert_refused(bpy.ops.dirichlet.patch_add_selected, obj, "No vertex of 'Grid' is selected")


def test_add_group_refuses_a_name_that_is_none():
    obj = painted_grid()
    with pytest.raises(RuntimeError, match="no vertex group 'nowhere'"):
        bpy.ops.dirichlet.patch_add_group(group="nowhere")
    assert len(obj.dirichlet.patches) == 2


def test_edges_alone_are_refused():
    obj = add([(0, 0, 0), (1, 0, 0)], [])
    obj.data.edges.add(1)
    paint(obj, "a", [0])
    assert_refused(bpy.ops.dirichlet.solve_field, obj, "face")


@pytest.mark.parametrize("function", ["solve_field", "make_isolines"])
def test_scripts_get_a_sentence_for_what_is_no_mesh_or_cannot_be_read(pipeline, surface, function):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(surface.InputError, match="'Grid' is in Edit Mode"):
        getattr(pipeline, function)(obj)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.empty_add()
    with pytest.raises(surface.InputError, match="'Empty' is not a mesh but of type EMPTY"):
        getattr(pipeline, function)(bpy.context.active_object)
