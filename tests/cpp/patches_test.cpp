// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/patches.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;
using Patch = std::vector<Index>;

PatchFacts inspect(const PolygonSoup& soup, const Patch& patch) {
  return inspect_patches(*make_mesh(soup), std::vector<Patch>{patch})[0];
}

Patch all_of(const PolygonSoup& soup) {
  Patch patch(soup.positions.size() / 3);
  std::iota(patch.begin(), patch.end(), 0);
  return patch;
}

/// Vertices of a grid of `width` columns in [i0, i1] × [j0, j1].
Patch block(Index width, Index i0, Index i1, Index j0, Index j1) {
  Patch patch;
  for (Index j = j0; j <= j1; ++j)
    for (Index i = i0; i <= i1; ++i) patch.push_back(i + j * width);
  return patch;
}

TEST(Patches, a_block_of_a_grid_is_a_disc) {
  for (const bool triangles : {true, false}) {
    const auto facts = inspect(makers::grid(6, 6, triangles), block(7, 1, 4, 2, 4));
    EXPECT_EQ(facts.vertices, 12);
    EXPECT_EQ(facts.faces, triangles ? 12 : 6);
    EXPECT_EQ(facts.edges, triangles ? 23 : 17);
    EXPECT_EQ(facts.components, 1);
    EXPECT_EQ(facts.euler_characteristic, 1);
    EXPECT_EQ(facts.border_loops, 1);
    EXPECT_TRUE(facts.manifold);
    EXPECT_TRUE(facts.disc);
    EXPECT_TRUE(facts.overlaps.empty());
  }
}

TEST(Patches, a_single_vertex_is_a_piece_without_a_surface) {
  const auto facts = inspect(makers::grid(3, 3), {5});
  EXPECT_EQ(facts.vertices, 1);
  EXPECT_EQ(facts.edges, 0);
  EXPECT_EQ(facts.faces, 0);
  EXPECT_EQ(facts.components, 1);
  EXPECT_EQ(facts.euler_characteristic, 1);
  EXPECT_FALSE(facts.manifold);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, a_row_of_vertices_has_edges_only) {
  const auto facts = inspect(makers::grid(5, 5), block(6, 0, 3, 2, 2));
  EXPECT_EQ(facts.edges, 3);
  EXPECT_EQ(facts.faces, 0);
  EXPECT_EQ(facts.components, 1);
  EXPECT_EQ(facts.euler_characteristic, 1);
  EXPECT_EQ(facts.border_loops, 0);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, a_ring_has_euler_characteristic_0_and_two_border_loops) {
  Patch ring = block(7, 1, 5, 1, 5);
  std::erase(ring, 3 + 3 * 7);
  const auto facts = inspect(makers::grid(6, 6), ring);
  EXPECT_EQ(facts.euler_characteristic, 0);
  EXPECT_EQ(facts.border_loops, 2);
  EXPECT_EQ(facts.components, 1);
  EXPECT_TRUE(facts.manifold);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, two_discs_in_one_patch_are_no_disc) {
  Patch patch = block(9, 0, 2, 0, 2);
  const Patch other = block(9, 5, 7, 5, 7);
  patch.insert(patch.end(), other.begin(), other.end());
  const auto facts = inspect(makers::grid(8, 8), patch);
  EXPECT_EQ(facts.components, 2);
  EXPECT_EQ(facts.euler_characteristic, 2);
  EXPECT_EQ(facts.border_loops, 2);
  EXPECT_TRUE(facts.manifold);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, a_triangle_and_a_whole_torus_are_no_disc_though_they_count_like_one) {
  PolygonSoup soup = makers::torus(6, 5);
  soup.faces.push_back({30, 31, 32});
  soup.positions.resize(3 * 33);
  const auto facts = inspect(soup, all_of(soup));
  EXPECT_EQ(facts.euler_characteristic, 1);
  EXPECT_EQ(facts.border_loops, 1);
  EXPECT_EQ(facts.components, 2);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, a_whole_sphere_and_a_whole_torus_have_no_border) {
  for (const auto& [soup, euler] : {std::pair{makers::sphere(5, 8), 2}, std::pair{makers::torus(6, 5, false), 0}}) {
    const auto facts = inspect(soup, all_of(soup));
    EXPECT_EQ(facts.euler_characteristic, euler);
    EXPECT_EQ(facts.border_loops, 0);
    EXPECT_EQ(facts.components, 1);
    EXPECT_TRUE(facts.manifold);
    EXPECT_FALSE(facts.disc);
  }
}

TEST(Patches, two_triangles_that_touch_in_a_vertex_are_not_manifold) {
  const auto facts =
      inspect({{0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0}, {{0, 1, 2}, {0, 3, 4}}}, {0, 1, 2, 3, 4});
  EXPECT_EQ(facts.components, 1);
  EXPECT_EQ(facts.euler_characteristic, 1);
  EXPECT_FALSE(facts.manifold);
  EXPECT_EQ(facts.border_loops, 0);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, two_closed_surfaces_that_touch_in_a_vertex_are_not_manifold_in_any_order_of_faces) {
  std::vector<Patch> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), 0U);
  PolygonSoup soup{std::vector<double>(21, 0.0), {}};
  for (int round = 0; round < 500; ++round) {
    soup.faces.clear();
    for (const std::size_t f : order) soup.faces.push_back(faces[f]);
    EXPECT_FALSE(inspect(soup, all_of(soup)).manifold);
    for (int step = 0; step < 79; ++step) std::next_permutation(order.begin(), order.end());
  }
}

TEST(Patches, three_faces_on_an_edge_are_not_manifold_and_two_of_them_are_a_disc) {
  const PolygonSoup book{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  testing::internal::CaptureStderr();
  EXPECT_FALSE(inspect(book, all_of(book)).manifold);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(inspect(book, {0, 1, 2, 3}).disc);
}

TEST(Patches, a_disc_stays_one_when_every_other_face_is_flipped) {
  PolygonSoup soup = makers::grid(6, 6);
  for (std::size_t f = 0; f < soup.faces.size(); f += 2) std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  const auto facts = inspect(soup, block(7, 1, 4, 2, 4));
  EXPECT_TRUE(facts.manifold);
  EXPECT_EQ(facts.border_loops, 1);
  EXPECT_TRUE(facts.disc);
}

TEST(Patches, a_disc_with_a_loose_edge_is_no_disc) {
  Patch patch = block(7, 0, 2, 0, 2);
  patch.push_back(3 + 1 * 7); // beside the middle of the right side: it joins one edge, no quad
  const auto facts = inspect(makers::grid(6, 6, false), patch);
  EXPECT_EQ(facts.components, 1);
  EXPECT_EQ(facts.euler_characteristic, 1);
  EXPECT_EQ(facts.border_loops, 1);
  EXPECT_TRUE(facts.manifold);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, repeated_vertices_count_once_in_any_order) {
  Patch patch = block(7, 1, 4, 2, 4);
  patch.insert(patch.end(), patch.rbegin(), patch.rend());
  const auto facts = inspect(makers::grid(6, 6), patch);
  EXPECT_EQ(facts.vertices, 12);
  EXPECT_EQ(facts.faces, 12);
  EXPECT_TRUE(facts.disc);
}

TEST(Patches, an_empty_patch_is_nothing) {
  const auto facts = inspect(makers::grid(2, 2), {});
  EXPECT_EQ(facts.vertices, 0);
  EXPECT_EQ(facts.components, 0);
  EXPECT_EQ(facts.euler_characteristic, 0);
  EXPECT_FALSE(facts.manifold);
  EXPECT_FALSE(facts.disc);
}

TEST(Patches, overlaps_are_found_both_ways_and_touching_is_not_overlapping) {
  const auto mesh = make_mesh(makers::grid(8, 8));
  const std::vector<Patch> patches{
      block(9, 0, 2, 0, 2), block(9, 2, 4, 2, 4), block(9, 5, 6, 2, 4), {}, block(9, 0, 4, 0, 4)};
  const auto facts = inspect_patches(*mesh, patches);
  EXPECT_EQ(facts[0].overlaps, (Patch{1, 4}));
  EXPECT_EQ(facts[1].overlaps, (Patch{0, 4}));
  EXPECT_TRUE(facts[2].overlaps.empty());
  EXPECT_TRUE(facts[3].overlaps.empty());
  EXPECT_EQ(facts[4].overlaps, (Patch{0, 1}));
}

TEST(Patches, what_one_patch_is_does_not_depend_on_the_others) {
  const auto soup = makers::torus(8, 6);
  const auto mesh = make_mesh(soup);
  const std::vector<Patch> patches{{0, 1, 8, 9}, all_of(soup), {5}, {0, 1, 8, 9}};
  const auto facts = inspect_patches(*mesh, patches);
  for (const std::size_t p : {0U, 3U}) {
    EXPECT_EQ(facts[p].faces, 2);
    EXPECT_EQ(facts[p].edges, 5);
    EXPECT_TRUE(facts[p].disc);
  }
  EXPECT_EQ(facts[1].faces, 96);
}

TEST(Patches, an_index_out_of_range_is_named_with_its_patch) {
  const auto mesh = make_mesh(makers::grid(3, 3));
  EXPECT_REFUSED(inspect_patches(*mesh, std::vector<Patch>{{0, 1}, {2, 16, -1}}), InputError, "patch 1", "vertex 16",
                 "0 to 15", "1 more");
  EXPECT_REFUSED(inspect_patches(*mesh, std::vector<Patch>{{-1}}), InputError, "patch 0", "vertex -1");
}

} // namespace
} // namespace dirichlet
