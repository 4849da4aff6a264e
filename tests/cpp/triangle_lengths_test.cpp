// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_lengths.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh_makers.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

TEST(TriangleLengths, area_and_cotangents_are_those_of_the_angles_at_any_scale) {
  for (const double scale : {1e-290, 1e-160, 1.0, 1e150, 1e290}) {
    const Sides right{3 * scale, 4 * scale, 5 * scale};
    const Sides cotangents = half_cotangents(right);
    EXPECT_NEAR(cotangents[0], 0.5 * 4 / 3, 1e-15);
    EXPECT_NEAR(cotangents[1], 0.5 * 3 / 4, 1e-15);
    EXPECT_NEAR(cotangents[2], 0, 1e-15);
    if (scale >= 1e-150 && scale <= 1e150) {
      EXPECT_NEAR(triangle_area(right) / scale / scale, 6, 1e-14);
    }
  }
}

TEST(TriangleLengths, a_needle_keeps_its_area) {
  for (const double thin : {1e-3, 1e-9, 1e-15, 1e-100}) {
    EXPECT_NEAR(triangle_area({1, 1, thin}) / (thin / 2), 1, 1e-6);
    EXPECT_NEAR(half_cotangents({1, thin, 1})[1] * thin, 0.5, 1e-6);
  }
}

TEST(TriangleLengths, lengths_that_make_no_triangle_have_no_area_until_they_are_mollified) {
  for (const Sides& flat : {Sides{1, 1, 2}, Sides{1, 1, 2.1}, Sides{0, 1, 1}, Sides{1e-200, 5, 5}, Sides{0, 0, 0}}) {
    EXPECT_LE(triangle_area(flat), 1e-199);
    const Sides near = mollified(flat);
    EXPECT_GT(triangle_area(near), 0);
    for (const double cotangent : half_cotangents(near)) EXPECT_TRUE(std::isfinite(cotangent));
  }
  EXPECT_EQ(mollification({3, 4, 5}), 0);
}

TEST(TriangleLengths, of_a_mesh_do_not_depend_on_its_scale) {
  const auto soup = makers::sphere(5, 8);
  const SideLengths unit = measure_sides(*make_mesh(soup));
  for (const int exponent : {-530, 490}) { // about 1e-160 and 1e147
    auto scaled = soup;
    for (double& x : scaled.positions) x = std::ldexp(x, exponent);
    const SideLengths sides = measure_sides(*make_mesh(scaled));
    EXPECT_EQ(sides.lengths, unit.lengths);
    EXPECT_EQ(sides.unit, std::ldexp(unit.unit, exponent));
  }
  EXPECT_EQ(unit.mollification, 0);
  EXPECT_EQ(unit.mollified, 0);
}

TEST(TriangleLengths, of_a_mesh_with_flat_faces_make_triangles_after_mollification) {
  auto soup = makers::grid(6, 6);
  for (const std::size_t v :
       {9U, 10U, 16U, 17U, 18U}) // a block falls onto one of its vertices, one beside lies on a line
    for (std::size_t k = 0; k < 3; ++k) soup.positions[3 * v + k] = soup.positions[3 * 9 + k];
  const auto mesh = make_mesh(soup);
  const SideLengths sides = measure_sides(*mesh);
  EXPECT_GT(sides.mollification, 0);
  EXPECT_LE(sides.mollification, 1e-11);
  EXPECT_GT(sides.mollified, 4);
  for (Index face = 0; face < mesh->face_count(); ++face) EXPECT_GT(triangle_area(sides.of(face)), 0);
}

} // namespace
} // namespace dirichlet
