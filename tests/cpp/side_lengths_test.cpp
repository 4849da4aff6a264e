// SPDX-License-Identifier: GPL-3.0-or-later
#include "side_lengths.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "index.h"
#include "mesh_makers.h"
#include "triangle_lengths.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

Sides sides_of(const Buffer<double>& lengths, Index face) {
  return {lengths[3 * at(face)], lengths[3 * at(face) + 1], lengths[3 * at(face) + 2]};
}

TEST(MollifiedSides, of_proper_triangles_are_their_lengths_and_do_not_depend_on_the_scale) {
  const auto soup = makers::grid(4, 3);
  const Buffer<double> lengths = mollified_sides(*make_mesh(soup)).lengths;
  for (Index face = 0; face < 24; ++face) {
    Sides sides = sides_of(lengths, face);
    std::sort(sides.begin(), sides.end());
    EXPECT_EQ(sides, (Sides{0.25, 0.25, 0.25 * std::sqrt(2.0)}));
  }
  for (const int exponent : {-530, 490}) { // about 1e-160 and 1e147
    auto scaled = soup;
    for (double& x : scaled.positions) x = std::ldexp(x, exponent);
    EXPECT_EQ(mollified_sides(*make_mesh(scaled)).lengths, lengths);
  }
}

/// A grid of which a block has shrunk to nearly a point, a row lies on a line, and a face beside it is a point.
PolygonSoup damaged_grid(double size) {
  PolygonSoup soup = makers::grid(12, 12);
  double* const p = soup.positions.data();
  const auto shrink = [&](std::size_t to, std::size_t v) {
    for (std::size_t k = 0; k < 2; ++k) p[3 * v + k] = p[3 * to + k] + size * (p[3 * v + k] - p[3 * to + k]);
  };
  for (std::size_t j = 2; j < 7; ++j)
    for (std::size_t i = 2; i < 8; ++i)
      if (i != 5 || j != 5) shrink(5 + 5 * 13, i + j * 13);
  for (std::size_t i = 1; i < 12; i += 2) p[3 * (i + 10 * 13) + 1] = 11 - size;
  const auto n = static_cast<Index>(soup.positions.size() / 3);
  soup.positions.insert(soup.positions.end(), {0, 0, 0, 0, 0, 0, 50, 0, 0, 50, 0, 0, 50, 0, 0});
  soup.faces.push_back({0, n, n + 1});
  soup.faces.push_back({n + 2, n + 3, n + 4}); // and one is a piece of its own
  return soup;
}

TEST(MollifiedSides, make_triangles_whatever_the_faces) {
  for (const double size : {1e-4, 1e-7, 1e-10, 1e-13, 1e-16, 1e-40, 1e-200, 0.0}) {
    const auto mesh = make_mesh(damaged_grid(size));
    const Buffer<double> lengths = mollified_sides(*mesh).lengths;
    for (Index face = 0; face < mesh->face_count(); ++face)
      for (const double cotangent : half_cotangents(sides_of(lengths, face)))
        EXPECT_LE(std::abs(cotangent), 2e13) << "size " << size << ", face " << face;
  }
}

TEST(MollifiedSides, differ_by_no_more_than_it_takes_and_only_where_it_takes) {
  const auto mesh = make_mesh(damaged_grid(0));
  const auto good = make_mesh(makers::grid(12, 12));
  const Buffer<double> lengths = mollified_sides(*mesh).lengths;
  std::map<std::pair<Index, Index>, double> of_edge;
  Index untouched = 0;
  for (Index c = 0; c + 3 < static_cast<Index>(lengths.size()); ++c) {
    const Index a = mesh->corners()[at(c)], b = mesh->corners()[at(next_in_triangle(c))];
    const double* const p = mesh->positions().data();
    const double length = std::hypot(p[3 * at(a)] - p[3 * at(b)], p[3 * at(a) + 1] - p[3 * at(b) + 1]) / 32;
    EXPECT_LE(std::abs(lengths[at(c)] - length), 1e-7);
    untouched += lengths[at(c)] == length ? 1 : 0;
    const auto [known, is_new] = of_edge.emplace(std::minmax(a, b), lengths[at(c)]);
    EXPECT_EQ(known->second, lengths[at(c)]);
  }
  EXPECT_GT(untouched, 300);
}

} // namespace
} // namespace dirichlet
