# SPDX-License-Identifier: GPL-3.0-or-later
"""What isolines are written as: legacy curve, mesh edges, curves; the same lines in each."""

from itertools import pairwise

import bpy
import numpy as np
import pytest
from refusal import data_counts
from scene import painted_grid, painted_sphere

CAN_MAKE_CURVES = "set_types" in bpy.types.Curves.bl_rna.functions
OUTPUTS = ["CURVE", "MESH", *(["CURVES"] if CAN_MAKE_CURVES else [])]
OF_LINES = ("dirichlet_level", "dirichlet_closed", "dirichlet_length", "dirichlet_line")


@pytest.fixture(params=["sphere", "sheet"])
def surface_object(request):
    obj = painted_sphere() if request.param == "sphere" else painted_grid(columns=9)
    bpy.ops.dirichlet.solve_field()
    return obj


def make(obj, output):
    obj.dirichlet.output = output
    assert bpy.ops.dirichlet.make_isolines() == {"FINISHED"}
    return obj.dirichlet.isolines


def attribute(data, name):
    return np.array([item.value for item in data.attributes[name].data])


def lines_of_curve(curve):
    """Points, level, closed and length of every line."""
    points = [np.array([point.co[:3] for point in spline.points], np.float32) for spline in curve.splines]
    closed = [spline.use_cyclic_u for spline in curve.splines]
    return points, np.float32(curve["dirichlet_level"]), closed, np.float32(curve["dirichlet_length"])


def lines_of_mesh(mesh):
    points = np.array([vertex.co for vertex in mesh.vertices], np.float32)
    starts = np.flatnonzero(np.diff(attribute(mesh, "dirichlet_line"), prepend=-1))
    level, closed, length, line = (attribute(mesh, name)[starts] for name in OF_LINES)
    assert line.tolist() == list(range(len(starts)))
    return np.split(points, starts[1:]), np.float32(level), closed.astype(bool).tolist(), np.float32(length)


def lines_of_curves(curves):
    points = np.array([point.position for point in curves.points], np.float32)
    level, closed, length, line = (attribute(curves, name) for name in OF_LINES)
    assert line.tolist() == list(range(len(curves.curves)))
    assert attribute(curves, "cyclic").tolist() == closed.tolist()
    assert set(attribute(curves, "curve_type").tolist()) == {1}  # poly
    starts = [curve.first_point_index for curve in curves.curves]
    return np.split(points, starts[1:]), np.float32(level), closed.astype(bool).tolist(), np.float32(length)


ITEMS = {"CURVE": "splines", "MESH": "vertices", "CURVES": "curves"}
READERS = {"CURVE": lines_of_curve, "MESH": lines_of_mesh, "CURVES": lines_of_curves}


@pytest.mark.parametrize("output", OUTPUTS[1:])
def test_every_output_holds_the_lines_of_the_curve(surface_object, output):
    expected = lines_of_curve(make(surface_object, "CURVE").data)
    points, *rest = READERS[output](make(surface_object, output).data)
    assert len(points) == len(expected[0]) > 0
    assert all(map(np.array_equal, points, expected[0]))
    assert all(map(np.array_equal, rest, expected[1:]))


def test_edges_join_successive_points_and_close_closed_lines(surface_object):
    mesh = make(surface_object, "MESH").data
    line, closed = attribute(mesh, "dirichlet_line"), attribute(mesh, "dirichlet_closed")
    edges = {tuple(sorted(edge.vertices)) for edge in mesh.edges}
    expected = set()
    for number in range(line.max() + 1):
        ring = np.flatnonzero(line == number).tolist()
        expected |= set(pairwise(ring))
        if closed[ring[0]]:
            expected.add((ring[0], ring[-1]))
    assert edges == expected
    assert len(mesh.edges) == len(edges)


@pytest.mark.parametrize("output", OUTPUTS[1:])
def test_points_carry_the_thickness_and_the_color_of_their_level(surface_object, output):
    curve = make(surface_object, "CURVE").data
    radius, colors = curve.bevel_depth, [material.diffuse_color[:] for material in curve.materials]
    data = make(surface_object, output).data
    assert np.allclose(attribute(data, "radius"), radius)
    shown = np.array([item.color for item in data.attributes["dirichlet_color"].data])
    levels = attribute(data, "dirichlet_level")
    assert np.allclose(shown, np.array(colors)[np.searchsorted(np.unique(levels), levels)])


@pytest.mark.parametrize("first", OUTPUTS)
@pytest.mark.parametrize("second", OUTPUTS)
def test_switching_the_output_replaces_the_object_in_its_place(surface_object, first, second):
    other = bpy.data.collections.new("other")
    bpy.context.scene.collection.children.link(other)
    before = make(surface_object, first)
    before.name, before.location, before.hide_render = "Rings", (0, 0, 0.5), True
    other.objects.link(before)
    bpy.context.scene.collection.objects.unlink(before)
    child = bpy.data.objects.new("child", None)
    child.parent = before
    child.matrix_parent_inverse[0][3] = 5
    made = make(surface_object, second)
    assert (made.type, made.name, made.parent) == (second, "Rings", surface_object)
    assert (made.location[:], made.hide_render, list(made.users_collection)) == ((0, 0, 0.5), True, [other])
    assert (child.parent, child.matrix_parent_inverse[0][3]) == (made, 5)
    assert [obj.name for obj in surface_object.children] == ["Rings"]


@pytest.mark.parametrize("active", [False, True])
def test_switching_the_output_keeps_the_selection(module, active):
    obj = painted_grid()
    bpy.ops.dirichlet.solve_field()
    result = make(obj, "CURVE")
    result.select_set(active)
    bpy.context.view_layer.objects.active = result if active else obj
    obj.dirichlet.output = "MESH"
    made = module("work").run(module("several").refresh([result])).results[0].object
    assert (made.select_get(), bpy.context.view_layer.objects.active == made) == (active, active)


def test_switching_there_and_back_leaves_nothing_behind(surface_object):
    make(surface_object, "CURVE")
    counts = data_counts()
    for output in (*OUTPUTS, "CURVE"):
        make(surface_object, output)
    assert data_counts() == counts


@pytest.mark.parametrize("output", OUTPUTS)
def test_no_line_at_all_gives_an_empty_result(surface_object, output):
    make(surface_object, output)
    surface_object.dirichlet.levels_mode, surface_object.dirichlet.levels_list = "LIST", "7"
    data = make(surface_object, output).data
    assert len(getattr(data, ITEMS[output])) == 0


@pytest.mark.parametrize("output", OUTPUTS)
def test_undo_brings_the_output_before_back(output):
    painted_sphere()
    bpy.ops.ed.undo_push(message="painted")
    bpy.ops.dirichlet.solve_field("EXEC_DEFAULT", True)
    bpy.ops.dirichlet.make_isolines("EXEC_DEFAULT", True)
    bpy.data.objects["Sphere"].dirichlet.output = output
    bpy.ops.ed.undo_push(message="output")
    bpy.ops.dirichlet.make_isolines("EXEC_DEFAULT", True)
    assert bpy.data.objects["Sphere"].dirichlet.isolines.type == output
    bpy.ops.ed.undo()
    assert bpy.data.objects["Sphere"].dirichlet.isolines.type == "CURVE"
    bpy.ops.ed.redo()
    assert bpy.data.objects["Sphere"].dirichlet.isolines.type == output


def test_geometry_nodes_read_level_closed_and_length_of_the_legacy_curve(surface_object):
    target = make(surface_object, "CURVE")
    _, level, closed, length = lines_of_curve(target.data)
    target.data.bevel_depth = 0
    sizes = [len(spline.points) for spline in target.data.splines]
    read = attributes_in_geometry_nodes(target, {
        "level": ("GeometryNodeInputCurveTilt", 0, "POINT"),
        "closed": ("GeometryNodeInputSplineCyclic", 0, "CURVE"),
        "length": ("GeometryNodeSplineLength", 0, "CURVE"),
    })  # fmt: skip
    assert np.array_equal(read["level"], np.repeat(level, sizes))
    assert np.array_equal(read["closed"], np.repeat(np.float32(closed), sizes))
    assert np.allclose(read["length"], np.repeat(length, sizes), rtol=1e-4)


def attributes_in_geometry_nodes(curve, fields):
    """Every field, (node type, socket, domain), of the curve's points as geometry nodes of another object see it."""
    tree = bpy.data.node_groups.new("read", "GeometryNodeTree")
    if bpy.app.version >= (4, 0, 0):
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        tree.outputs.new("NodeSocketGeometry", "Geometry")
    info = tree.nodes.new("GeometryNodeObjectInfo")
    info.inputs["Object"].default_value = curve
    last = info.outputs["Geometry"]
    for name, (kind, socket, domain) in fields.items():
        store = tree.nodes.new("GeometryNodeStoreNamedAttribute")
        store.data_type, store.domain = "FLOAT", domain
        store.inputs["Name"].default_value = name
        value = next(found for found in store.inputs if found.enabled and found.name == "Value")
        tree.links.new(tree.nodes.new(kind).outputs[socket], value)
        tree.links.new(last, store.inputs["Geometry"])
        last = store.outputs["Geometry"]
    to_mesh = tree.nodes.new("GeometryNodeCurveToMesh")
    tree.links.new(last, to_mesh.inputs["Curve"])
    tree.links.new(to_mesh.outputs[0], tree.nodes.new("NodeGroupOutput").inputs[0])
    reader = bpy.data.objects.new("reader", bpy.data.meshes.new("reader"))
    bpy.context.collection.objects.link(reader)
    reader.modifiers.new("read", "NODES").node_group = tree
    mesh = reader.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    return {name: np.float32(attribute(mesh, name)) for name in fields}
