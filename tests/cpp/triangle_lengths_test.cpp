// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_lengths.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dirichlet {
namespace {

TEST(TriangleLengths, cotangents_are_those_of_the_angles_at_any_scale) {
  for (const double scale : {1e-290, 1e-160, 1.0, 1e150, 1e290}) {
    const Sides right{3 * scale, 4 * scale, 5 * scale};
    const Sides cotangents = half_cotangents(right);
    EXPECT_NEAR(cotangents[0], 0.5 * 4 / 3, 1e-15);
    EXPECT_NEAR(cotangents[1], 0.5 * 3 / 4, 1e-15);
    EXPECT_NEAR(cotangents[2], 0, 1e-15);
  }
}

TEST(TriangleLengths, a_needle_keeps_its_angles) {
  for (const double thin : {1e-3, 1e-9, 1e-15, 1e-100}) EXPECT_NEAR(half_cotangents({1, thin, 1})[1] * thin, 0.5, 1e-6);
}

TEST(TriangleLengths, what_makes_no_triangle_has_no_finite_angles) {
  for (const Sides& flat : {Sides{1, 1, 2}, Sides{1, 1, 2.1}, Sides{0, 1, 1}, Sides{0, 0, 0}})
    EXPECT_FALSE(std::isfinite(half_cotangents(flat)[2]));
}

} // namespace
} // namespace dirichlet
