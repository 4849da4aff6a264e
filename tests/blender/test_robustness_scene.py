# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of other files, instances, and objects that Blender does not evaluate: each works, or is said."""

import bpy
import numpy as np
import pytest
from refusal import assert_refused, data_counts
from scene import field_of, painted_grid

OPERATORS = (
    "solve_field",
    "check_patches",
    "patch_add_selected",
    "patch_add_group",
    "patch_paint",
    "patches_from_pieces",
)


@pytest.fixture
def library(tmp_path):
    """A file with a painted, solved grid whose collection is 'Shelf'."""
    obj = painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    shelf = bpy.data.collections.new("Shelf")
    bpy.context.scene.collection.children.link(shelf)
    shelf.objects.link(obj)
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    return path


def add_from(path, kind, name):
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        setattr(wanted, kind, [name])
    return getattr(wanted, kind)[0]


def activate(obj):
    bpy.context.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    return obj


def linked_object(path):
    return activate(add_from(path, "objects", "Grid"))


def linked_mesh(path):
    obj = activate(bpy.data.objects.new("Mine", add_from(path, "meshes", "Grid")))
    patch = obj.dirichlet.patches.add()
    patch.group = "left"
    return obj


def overridden(path):
    return activate(add_from(path, "objects", "Grid").override_create())


@pytest.mark.parametrize("operator", OPERATORS)
@pytest.mark.parametrize("make", [linked_object, linked_mesh, overridden], ids=lambda make: make.__name__)
def test_what_belongs_to_another_file_is_refused_by_every_poll(library, make, operator):
    obj = make(library)
    before = data_counts()
    with pytest.raises(RuntimeError, match="The object is linked from another file: make it and its data local first"):
        getattr(bpy.ops.dirichlet, operator)()
    assert data_counts() == before
    assert obj.data.library is not None


def test_selected_objects_of_other_files_are_left_out(library):
    theirs, mine = linked_object(library), painted_grid(columns=9, name="Mine")
    theirs.select_set(True)
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert mine.dirichlet.results.solved


def test_made_local_it_is_solved(library):
    obj = linked_object(library)
    bpy.ops.object.make_local(type="SELECT_OBDATA")
    obj = bpy.context.active_object
    obj.dirichlet.patches[1].value = 2.0
    assert bpy.ops.dirichlet.solve_field() == {"FINISHED"}
    assert field_of(obj).max() == 2


def test_an_instance_of_a_collection_is_no_mesh():
    obj = painted_grid()
    shelf = bpy.data.collections.new("Shelf")
    shelf.objects.link(obj)
    instance = bpy.data.objects.new("Instance", None)
    instance.instance_type, instance.instance_collection = "COLLECTION", shelf
    activate(instance)
    with pytest.raises(RuntimeError, match="Select a mesh object first"):
        bpy.ops.dirichlet.solve_field()


def make_instances(obj):
    """Geometry nodes that show the mesh as an instance of itself: the evaluated mesh has no faces of its own."""
    tree = bpy.data.node_groups.new("Instances", "GeometryNodeTree")
    if bpy.app.version >= (4, 0, 0):
        for direction in ("INPUT", "OUTPUT"):
            tree.interface.new_socket("Geometry", in_out=direction, socket_type="NodeSocketGeometry")
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
    entry, way, end = (
        tree.nodes.new(f"{kind}") for kind in ("NodeGroupInput", "GeometryNodeGeometryToInstance", "NodeGroupOutput")
    )
    tree.links.new(entry.outputs[0], way.inputs[0])
    tree.links.new(way.outputs[0], end.inputs[0])
    obj.modifiers.new("Instances", "NODES").node_group = tree


def test_an_object_that_shows_instances_has_lines_on_its_mesh_and_says_so():
    obj = painted_grid(columns=9)
    make_instances(obj)
    bpy.ops.dirichlet.solve_field()
    bpy.ops.dirichlet.make_isolines()
    assert obj.dirichlet.results.lines == obj.dirichlet.count
    assert "modifiers of object 'Grid' change its faces" in obj.dirichlet.results.isoline_warnings
    obj.dirichlet.use_modifiers = True
    assert_refused(bpy.ops.dirichlet.solve_field, obj, "'Grid' make 0 vertices and 0 faces of the 63 vertices and 48")


def hidden_by_eye(obj):
    obj.hide_set(True)


def hidden_with_its_collection(obj):
    collection = bpy.data.collections.new("Hidden")
    bpy.context.scene.collection.children.link(collection)
    collection.objects.link(obj)
    bpy.context.scene.collection.objects.unlink(obj)
    bpy.context.view_layer.layer_collection.children["Hidden"].hide_viewport = True


def disabled_in_viewports(obj):
    obj.hide_viewport = True


def excluded(obj):
    hidden_with_its_collection(obj)
    bpy.context.view_layer.layer_collection.children["Hidden"].exclude = True


def in_another_scene(obj):
    bpy.data.scenes.new("Other").collection.objects.link(obj)
    bpy.context.scene.collection.objects.unlink(obj)


def in_no_collection(obj):
    bpy.context.scene.collection.objects.unlink(obj)


HIDDEN = [hidden_by_eye, hidden_with_its_collection]
UNKNOWN = [disabled_in_viewports, excluded, in_another_scene, in_no_collection]  # Blender gives them no shape


def lift(obj):
    """A modifier that shows every vertex 2 higher."""
    modifier = obj.modifiers.new("Lift", "DISPLACE")
    modifier.strength, modifier.mid_level, modifier.direction = 2.0, 0.0, "Z"


def heights(obj):
    return {round(point.co.z, 5) for spline in obj.dirichlet.isolines.data.splines for point in spline.points}


@pytest.mark.parametrize("hide", HIDDEN + UNKNOWN, ids=lambda hide: hide.__name__)
def test_a_hidden_object_is_solved_as_a_shown_one(pipeline, hide):
    obj = painted_grid(columns=9)
    hide(obj)
    bpy.context.view_layer.update()
    values = pipeline.solve_field(obj).field.values
    assert np.allclose(values, np.tile(np.arange(9) / 8, 7))
    assert len(pipeline.make_isolines(obj).lines) == obj.dirichlet.count


@pytest.mark.parametrize("hide", HIDDEN, ids=lambda hide: hide.__name__)
def test_a_hidden_object_has_its_modifiers(pipeline, hide):
    obj = painted_grid(columns=9)
    lift(obj)
    obj.dirichlet.use_modifiers = True
    hide(obj)
    bpy.context.view_layer.update()
    pipeline.solve_field(obj)
    assert pipeline.make_isolines(obj).warnings == ()
    assert heights(obj) == {2.0}


@pytest.mark.parametrize("hide", UNKNOWN, ids=lambda hide: hide.__name__)
def test_modifiers_that_blender_does_not_evaluate_are_no_shape(pipeline, surface, hide):
    obj = painted_grid(columns=9)
    lift(obj)
    hide(obj)
    bpy.context.view_layer.update()
    obj.dirichlet.use_modifiers = True
    with pytest.raises(surface.InputError, match=r"'Grid' is disabled in viewports .*: enable it there, or switch off"):
        pipeline.solve_field(obj)
    obj.dirichlet.use_modifiers = False
    pipeline.solve_field(obj)
    warnings = pipeline.make_isolines(obj).warnings
    assert heights(obj) == {0.0}
    assert any("'Grid' is disabled in viewports or not in this view layer" in warning for warning in warnings)
