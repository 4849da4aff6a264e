// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh.h"

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "index.h"
#include "mesh_makers.h"
#include "parallel.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Index euler_characteristic(const Mesh& mesh) {
  return mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
}

/// (edge, corners) of every face, from scratch.
std::set<std::pair<Index, Index>> edges_of(const PolygonSoup& soup) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& face : soup.faces)
    for (std::size_t i = 0; i < face.size(); ++i) edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
  return edges;
}

TEST(Mesh, edges_are_the_polygon_edges_once_each_and_sorted) {
  for (const PolygonSoup& soup : {makers::grid(5, 3, false), makers::torus(7, 5), makers::sphere(4, 6)}) {
    const auto mesh = make_mesh(soup);
    const auto expected = edges_of(soup);
    const auto& edges = mesh->connectivity().edges;
    ASSERT_EQ(edges.size(), 2 * expected.size());
    std::size_t e = 0;
    for (const auto& [a, b] : expected) {
      EXPECT_EQ(edges[e++], a);
      EXPECT_EQ(edges[e++], b);
    }
  }
}

TEST(Mesh, opposite_half_edges_share_an_edge_and_find_each_other) {
  const auto mesh = make_mesh(makers::torus(6, 4, false));
  const Connectivity& c = mesh->connectivity();
  const auto ends = [&](Index h) { // of quads
    const Index a = mesh->corners()[at(h)], b = mesh->corners()[at(h % 4 == 3 ? h - 3 : h + 1)];
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (Index h = 0; h < static_cast<Index>(c.opposite.size()); ++h) {
    const Index other = c.opposite[at(h)];
    EXPECT_NE(other, h);
    EXPECT_EQ(ends(other), ends(h));
    EXPECT_EQ(c.opposite[at(other)], h);
  }
}

TEST(Mesh, connectivity_of_a_large_mesh_is_the_same_on_one_thread_and_on_all) {
  PolygonSoup soup = makers::torus(220, 200); // enough vertices for five threads
  std::shuffle(soup.faces.begin(), soup.faces.end(), std::mt19937(1));
  const auto shared = make_mesh(soup);
  thread_limit = 1;
  const auto alone = make_mesh(soup);
  thread_limit = 0;
  EXPECT_EQ(shared->connectivity().edges, alone->connectivity().edges);
  EXPECT_EQ(shared->connectivity().opposite, alone->connectivity().opposite);
  const auto expected = edges_of(soup);
  ASSERT_EQ(shared->connectivity().edges.size(), 2 * expected.size());
  std::size_t e = 0;
  for (const auto& [a, b] : expected) {
    ASSERT_EQ(shared->connectivity().edges[e++], a);
    ASSERT_EQ(shared->connectivity().edges[e++], b);
  }
}

TEST(Mesh, an_edge_of_three_faces_is_marked_non_manifold) {
  const auto mesh = make_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  const auto& opposite = mesh->connectivity().opposite;
  EXPECT_EQ(std::count(opposite.begin(), opposite.end(), Connectivity::kNonManifold), 3);
  EXPECT_EQ(std::count(opposite.begin(), opposite.end(), Connectivity::kBorder), 6);
}

TEST(Mesh, a_hub_with_ten_thousand_spokes_is_connected_like_any_other_vertex) {
  constexpr Index kSpokes = 10'000;
  PolygonSoup fan;
  fan.positions.assign(3 * (kSpokes + 1), 0.0);
  for (Index i = 0; i < kSpokes; ++i) fan.faces.push_back({0, 1 + i, 1 + (i + 1) % kSpokes});
  const auto mesh = make_mesh(fan);
  EXPECT_EQ(mesh->edge_count(), 2 * kSpokes);
  EXPECT_EQ(euler_characteristic(*mesh), 1);
}

TEST(Mesh, euler_characteristic_is_that_of_the_surface) {
  EXPECT_EQ(euler_characteristic(*make_mesh(makers::sphere(5, 8))), 2);
  EXPECT_EQ(euler_characteristic(*make_mesh(makers::torus(8, 5, false))), 0);
  EXPECT_EQ(euler_characteristic(*make_mesh(makers::grid(3, 3))), 1);
  EXPECT_EQ(euler_characteristic(*make_mesh(makers::moebius(9))), 0);
}

TEST(Mesh, components_are_numbered_by_their_lowest_vertex) {
  PolygonSoup two = makers::grid(1, 1);
  two.positions.insert(two.positions.end(), {5, 5, 5}); // isolated: vertex 4
  for (int i = 0; i < 9; ++i) two.positions.push_back(i);
  two.faces.push_back({7, 6, 5});
  const Components components = make_mesh(two)->components();
  EXPECT_EQ(components.count, 3);
  EXPECT_EQ(components.label, (std::vector<Index>{0, 0, 0, 0, 1, 2, 2, 2}));
}

TEST(Mesh, a_closed_surface_has_no_border_and_a_moebius_band_has_one) {
  EXPECT_EQ(make_mesh(makers::torus(5, 5))->border_loops().offsets.size(), 1U);
  const BorderLoops loops = make_mesh(makers::moebius(7))->border_loops();
  EXPECT_EQ(loops.offsets, (std::vector<Index>{0, 14}));
}

TEST(Mesh, a_border_loop_keeps_the_surface_on_its_left) {
  const BorderLoops loops = make_mesh(makers::grid(2, 1))->border_loops();
  EXPECT_EQ(loops.vertices, (std::vector<Index>{0, 1, 2, 5, 4, 3}));
}

TEST(Mesh, sheets_that_touch_in_a_vertex_keep_a_border_loop_each) {
  PolygonSoup two = makers::grid(2, 2, false);
  std::erase_if(two.faces, [](const auto& face) { return face[0] == 1 || face[0] == 3; });
  const BorderLoops loops = make_mesh(two)->border_loops();
  EXPECT_EQ(loops.offsets, (std::vector<Index>{0, 4, 8}));
}

TEST(Mesh, holes_that_touch_in_a_vertex_have_one_border_that_passes_it_twice) {
  PolygonSoup ring = makers::grid(4, 4, false);
  std::erase_if(ring.faces, [](const auto& face) { return face[0] == 6 || face[0] == 12; });
  const BorderLoops loops = make_mesh(ring)->border_loops();
  EXPECT_EQ(loops.offsets, (std::vector<Index>{0, 16, 24}));
  EXPECT_EQ(std::count(loops.vertices.begin() + 16, loops.vertices.end(), 12), 2);
}

TEST(Mesh, border_loops_of_a_fan_whose_sheets_share_an_edge_are_left_open_and_dropped) {
  const auto mesh = make_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  EXPECT_TRUE(mesh->border_loops().vertices.empty());
}

TEST(Mesh, direct_repeats_of_a_corner_count_once) {
  const auto mesh = make_mesh({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {{0, 1, 2, 2}, {2, 0, 1, 2}}});
  EXPECT_TRUE(mesh->is_triangular());
  EXPECT_EQ(mesh->face_count(), 2);
}

TEST(Mesh, faces_with_vertices_elsewhere_are_connected_as_before) {
  const auto mesh = make_mesh(makers::torus(7, 5));
  std::vector<double> elsewhere(mesh->positions().begin(), mesh->positions().end());
  for (double& x : elsewhere) x = 3 - 2 * x;
  const Mesh moved(*mesh, std::vector<double>(elsewhere));
  EXPECT_TRUE(std::ranges::equal(moved.positions(), elsewhere));
  EXPECT_TRUE(std::ranges::equal(moved.corners(), mesh->corners()));
  EXPECT_EQ(moved.connectivity().edges, mesh->connectivity().edges);
  EXPECT_EQ(moved.connectivity().opposite, mesh->connectivity().opposite);
  elsewhere.resize(3);
  EXPECT_THROW(Mesh(*mesh, std::move(elsewhere)), InputError);
}

TEST(Mesh, polygons_are_triangulated_over_the_same_vertices) {
  const auto mesh = make_mesh(makers::torus(6, 4, false));
  const Mesh& triangles = mesh->triangulated();
  EXPECT_TRUE(triangles.is_triangular());
  EXPECT_EQ(triangles.face_count(), 2 * mesh->face_count());
  EXPECT_EQ(triangles.positions().data(), mesh->positions().data());
  EXPECT_EQ(&triangles, &mesh->triangulated());
  EXPECT_EQ(&triangles.triangulated(), &triangles);
}

TEST(MeshRefuses, numbers_that_are_not_finite_naming_the_vertex) {
  for (const double bad : {kNan, kInfinity, 1e200}) {
    PolygonSoup soup = makers::grid(2, 2);
    soup.positions[3 * 5 + 1] = bad;
    soup.positions[3 * 7] = bad;
    EXPECT_REFUSED(make_mesh(soup), InputError, "vertex 5", "1 more");
  }
}

TEST(MeshRefuses, indices_out_of_range_naming_face_and_vertex) {
  PolygonSoup soup = makers::grid(2, 2, false);
  soup.faces[2][1] = 9;
  EXPECT_REFUSED(make_mesh(soup), InputError, "face 2", "vertex 9", "0 to 8");
  soup.faces[2][1] = -4;
  EXPECT_REFUSED(make_mesh(soup), InputError, "face 2", "vertex -4", "0 to 8");
}

TEST(MeshRefuses, faces_that_are_no_polygons_naming_the_face) {
  const auto with = [](std::vector<Index> face) {
    PolygonSoup soup = makers::grid(2, 2);
    soup.faces[3] = std::move(face);
    return soup;
  };
  EXPECT_REFUSED(make_mesh(with({4})), TopologyError, "face 3", "fewer than three");
  EXPECT_REFUSED(make_mesh(with({4, 5})), TopologyError, "face 3", "fewer than three");
  EXPECT_REFUSED(make_mesh(with({4, 4, 5})), TopologyError, "face 3", "fewer than three");
  EXPECT_REFUSED(make_mesh(with({})), TopologyError, "face 3", "no corners");
  EXPECT_REFUSED(make_mesh(with({4, 5, 4, 8})), TopologyError, "face 3", "vertex 4 twice");
}

TEST(MeshRefuses, what_is_empty_or_does_not_add_up) {
  const std::vector<double> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto make = [&](std::vector<Index> offsets, std::vector<Index> corners) {
    return Mesh(std::vector<double>(positions), offsets, corners);
  };
  EXPECT_REFUSED(make({0}, {}), InputError, "no faces");
  EXPECT_REFUSED(make({0, 2}, {0, 1, 2}), InputError, "run from 0 to 2");
  EXPECT_REFUSED(make({1, 3}, {0, 1, 2}), InputError, "run from 1 to 3");
  EXPECT_REFUSED(make({0, 6, 3, 9}, {0, 1, 2, 0, 1, 2, 0, 1, 2}), InputError, "descend at place 2");
  EXPECT_REFUSED(Mesh(std::vector<double>{0, 0}, std::vector<Index>{0, 1, 2}, 3), InputError, "multiple of 3");
  EXPECT_REFUSED(Mesh(std::vector<double>(positions), std::vector<Index>{0, 1}, 3), InputError, "faces of 3");
}

} // namespace
} // namespace dirichlet
