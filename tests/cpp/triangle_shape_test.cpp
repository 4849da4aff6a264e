// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_shape.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dirichlet {
namespace {

using Corners = std::array<Vector3, 3>;

double sum_of_products(const TriangleShape& shape) {
  const auto& [a, b, c] = shape.cotangents;
  return a * b + b * c + c * a;
}

TEST(TriangleShape, cotangents_and_area_of_a_right_triangle_at_any_scale) {
  for (const double size : {1e-160, 1e-20, 1.0, 3e7, 1e150}) {
    const TriangleShape shape = triangle_shape({Vector3{0, 0, 0}, {4 * size, 0, 0}, {0, 3 * size, 0}});
    EXPECT_NEAR(shape.cotangents[0], 0, 1e-15);
    EXPECT_NEAR(shape.cotangents[1], 4.0 / 3, 1e-14);
    EXPECT_NEAR(shape.cotangents[2], 3.0 / 4, 1e-14);
    EXPECT_NEAR(shape.area, 6 * size * size, 1e-14 * 6 * size * size);
  }
}

TEST(TriangleShape, a_needle_and_a_cap_keep_all_digits) {
  const double h = 1e-7;
  const TriangleShape needle = triangle_shape({Vector3{0, 0, 0}, {1, 0, 0}, {0, h, 0}});
  EXPECT_NEAR(needle.cotangents[1] * h, 1, 1e-14);
  EXPECT_NEAR(needle.cotangents[2] / h, 1, 1e-14);
  const TriangleShape cap = triangle_shape({Vector3{0, 0, 0}, {1, 0, 0}, {0.25, h, 0}});
  EXPECT_NEAR(cap.cotangents[0] * h, 0.25, 1e-14);
  EXPECT_NEAR(cap.cotangents[1] * h, 0.75, 1e-14);
  EXPECT_NEAR(cap.cotangents[2] * h, -0.1875, 1e-13);
}

TEST(TriangleShape, one_without_height_gets_the_least_there_is_above_its_foot_and_stays_a_triangle) {
  const Corners point{}, line{Vector3{0, 0, 0}, {8, 0, 0}, {2, 0, 0}}, pair{Vector3{0, 0, 0}, {0, 0, 0}, {5, 5, 5}};
  for (const Corners& corners : {point, line, pair}) {
    const TriangleShape shape = triangle_shape(corners);
    EXPECT_EQ(shape.area, 0);
    for (const double cotangent : shape.cotangents) EXPECT_LE(std::abs(cotangent), 1.01 / kLeastHeight);
    const auto& [a, b, c] = shape.cotangents;
    const double largest = std::max({std::abs(a * b), std::abs(b * c), std::abs(c * a)});
    EXPECT_NEAR(sum_of_products(shape), 1, 4e-16 * std::max(1.0, largest)); // the law of every triangle
  }
  const TriangleShape shape = triangle_shape(line);
  const double least = 4 * 0.25 * 0.75 * kLeastCap;
  EXPECT_DOUBLE_EQ(shape.cotangents[0] * least, 0.25);
  EXPECT_DOUBLE_EQ(shape.cotangents[1] * least, 0.75);
}

TEST(TriangleShape, does_not_depend_on_where_it_begins_or_its_winding) {
  const Corners corners{Vector3{0.1, 0.2, 0.3}, {1.7, -0.4, 0.9}, {0.6, 1.1, -2.0}};
  const auto [a, b, c] = corners;
  const TriangleShape shape = triangle_shape(corners), turned = triangle_shape({b, c, a}),
                      reversed = triangle_shape({c, b, a});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_DOUBLE_EQ(turned.cotangents[k], shape.cotangents[(k + 1) % 3]);
    EXPECT_DOUBLE_EQ(reversed.cotangents[k], shape.cotangents[2 - k]);
  }
}

} // namespace
} // namespace dirichlet
