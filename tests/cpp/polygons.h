// SPDX-License-Identifier: GPL-3.0-or-later
// Single polygons, and their triangles.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "dirichlet/triangulation.h"

namespace dirichlet {

using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;

inline Polygon in_plane(std::initializer_list<std::array<double, 2>> corners) {
  Polygon polygon;
  for (const auto& [x, y] : corners) polygon.push_back({x, y, 0});
  return polygon;
}

/// Corner i at radius(i), turning once.
template <class Radius>
Polygon around(Index count, Radius radius) {
  Polygon polygon;
  for (Index i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double r = radius(i);
    polygon.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return polygon;
}

/// Every side cut into three, at places that are not exactly on it.
inline Polygon with_split_sides(const Polygon& polygon) {
  Polygon split;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (const double t : {0.0, 0.3, 0.7}) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      split.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  return split;
}

inline Polygon tilted(Polygon polygon, double scale = 1, double offset = 0) {
  for (Point& p : polygon) {
    const auto [x, y, z] = p;
    p = {scale * (0.36 * x + 0.48 * y - 0.8 * z) + offset, scale * (-0.8 * x + 0.6 * y) - offset,
         scale * (0.48 * x + 0.64 * y + 0.6 * z) + offset};
  }
  return polygon;
}

inline std::vector<double> flatten(const Polygon& polygon) {
  std::vector<double> positions;
  for (const Point& p : polygon) positions.insert(positions.end(), p.begin(), p.end());
  return positions;
}

inline std::vector<Index> triangulate(const Polygon& polygon) {
  std::vector<Index> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), Index{0});
  return dirichlet::triangulate(flatten(polygon), std::vector<Index>{0, static_cast<Index>(polygon.size())}, corners);
}

inline bool crosses(const Polygon& polygon) {
  std::vector<Index> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), 0);
  const std::vector<Index> offsets{0, static_cast<Index>(corners.size())};
  return !find_crossing_faces(flatten(polygon), offsets, corners).empty();
}

/// Every side belongs to one triangle, in its direction, and every diagonal to two, in both.
inline testing::AssertionResult splits(std::size_t corner_count, const std::vector<Index>& triangles) {
  if (triangles.size() != 3 * (corner_count - 2)) return testing::AssertionFailure() << triangles.size() << " corners";
  std::map<std::pair<Index, Index>, int> half_edges;
  for (std::size_t c = 0; c < triangles.size(); ++c)
    ++half_edges[{triangles[c], triangles[c % 3 == 2 ? c - 2 : c + 1]}];
  for (const auto& [ends, uses] : half_edges) {
    const auto [a, b] = ends;
    const bool side = b == (a + 1) % static_cast<Index>(corner_count);
    if (uses != 1 || (!side && !half_edges.contains({b, a})))
      return testing::AssertionFailure() << "edge " << a << " " << b << " used " << uses << " times";
  }
  return testing::AssertionSuccess();
}

} // namespace dirichlet
