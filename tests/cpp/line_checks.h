// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for isolines of any field on any surface, and shorthands to look at them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "dirichlet/isolines.h"
#include "index.h"

namespace dirichlet {

using Point = std::array<double, 3>;

inline Point position(const Mesh& mesh, Index v) {
  const double* p = mesh.positions().data() + 3 * at(v);
  return {p[0], p[1], p[2]};
}

inline Point point(const Isolines& lines, std::size_t p) {
  return {lines.points[3 * p], lines.points[3 * p + 1], lines.points[3 * p + 2]};
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

inline std::size_t line_count(const Isolines& lines) {
  return lines.closed.size();
}

/// The points of line l.
inline std::vector<Point> line(const Isolines& lines, std::size_t l) {
  std::vector<Point> points;
  for (auto p = at(lines.offsets[l]); p < at(lines.offsets[l + 1]); ++p) points.push_back(point(lines, p));
  return points;
}

inline bool all_closed(const Isolines& lines) {
  return std::all_of(lines.closed.begin(), lines.closed.end(), [](std::uint8_t closed) { return closed == 1; });
}

/// f(x, y, z) at every vertex.
template <class Function>
std::vector<double> sample(const Mesh& mesh, Function f) {
  std::vector<double> values;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Point p = position(mesh, v);
    values.push_back(f(p[0], p[1], p[2]));
  }
  return values;
}

/// Whole numbers from 0 to `highest`, so that levels fall on vertices, edges and plateaus all the time.
inline std::vector<double> random_whole_numbers(const Mesh& mesh, int highest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(0, highest);
  return sample(mesh, [&](double, double, double) { return number(random); });
}

inline std::vector<double> random_numbers(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0, 1);
  return sample(mesh, [&](double, double, double) { return number(random); });
}

/// How many segments there are: every triangle has one for each level between its values.
inline std::size_t crossed_triangles(const Mesh& mesh, const std::vector<double>& field,
                                     const std::vector<double>& levels) {
  std::size_t count = 0;
  const auto corners = mesh.triangulated().corners();
  for (const double level : levels)
    for (std::size_t c = 0; c < corners.size(); c += 3) {
      const auto above = [&](std::size_t i) { return field[at(corners[c + i])] >= level; };
      if (above(0) != above(1) || above(1) != above(2)) ++count;
    }
  return count;
}

/// Arrays fit together, and every line has two or more points and a level.
inline void expect_consistent_arrays(const Isolines& lines, std::size_t level_count) {
  const std::size_t count = line_count(lines), points = lines.t.size();
  ASSERT_EQ(lines.points.size(), 3 * points);
  ASSERT_EQ(lines.edges.size(), 2 * points);
  ASSERT_EQ(lines.offsets.size(), count + 1);
  ASSERT_EQ(lines.level.size(), count);
  ASSERT_EQ(lines.length.size(), count);
  EXPECT_EQ(lines.offsets.front(), 0);
  EXPECT_EQ(at(lines.offsets.back()), points);
  EXPECT_TRUE(std::is_sorted(lines.level.begin(), lines.level.end()));
  for (std::size_t l = 0; l < count; ++l) {
    EXPECT_GE(lines.offsets[l + 1] - lines.offsets[l], 2);
    EXPECT_LT(at(lines.level[l]), level_count);
  }
}

/// Every point lies at t on an edge that its level crosses.
inline void expect_points_on_edges(const Mesh& mesh, const Isolines& lines, const std::vector<double>& field,
                                   const std::vector<double>& levels) {
  for (std::size_t l = 0; l < line_count(lines); ++l)
    for (auto p = at(lines.offsets[l]); p < at(lines.offsets[l + 1]); ++p) {
      const Index a = lines.edges[2 * p], b = lines.edges[2 * p + 1];
      const double level = levels[at(lines.level[l])], t = lines.t[p];
      ASSERT_LT(a, b);
      EXPECT_NE(field[at(a)] >= level, field[at(b)] >= level);
      EXPECT_TRUE(t >= 0 && t <= 1);
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(lines.points[3 * p + axis], std::lerp(position(mesh, a)[axis], position(mesh, b)[axis], t));
    }
}

/// No segment of length 0, and lengths are the sums of segments.
inline void expect_real_segments(const Isolines& lines) {
  for (std::size_t l = 0; l < line_count(lines); ++l) {
    const auto points = line(lines, l);
    double length = 0;
    for (std::size_t i = 0; i + 1 < points.size() + lines.closed[l]; ++i) {
      const Point& next = points[(i + 1) % points.size()];
      EXPECT_NE(points[i], next);
      length += distance(points[i], next);
    }
    EXPECT_GT(lines.length[l], 0);
    EXPECT_NEAR(lines.length[l], length, 1e-13 * length);
  }
}

/// Edges that do not lead from one triangle to another, all of whose corners have values: those of a border, of three
/// faces or more, and those beside NaN.
inline std::set<std::array<Index, 2>> edges_without_a_way_on(const Mesh& mesh, const std::vector<double>& field) {
  std::map<std::array<Index, 2>, std::array<int, 2>> triangles; // by edge: all, and those with values
  const auto corners = mesh.triangulated().corners();
  for (Index c = 0; c < static_cast<Index>(corners.size()); ++c) {
    const Index a = corners[at(c)], next = next_in_triangle(c), b = corners[at(next)];
    const Index opposite = corners[at(next_in_triangle(next))];
    auto& [all, valued] = triangles[{std::min(a, b), std::max(a, b)}];
    ++all;
    valued += std::isnan(field[at(a)] + field[at(b)] + field[at(opposite)]) ? 0 : 1;
  }
  std::set<std::array<Index, 2>> edges;
  for (const auto& [edge, counts] : triangles)
    if (counts != std::array{2, 2}) edges.insert(edge);
  return edges;
}

/// Open lines end on such an edge, or at a point of one: of points that coincide, that on another edge may have stayed.
inline void expect_ends_where_lines_may_end(const Mesh& mesh, const Isolines& lines, const std::vector<double>& field,
                                            const std::vector<double>& levels) {
  const auto edges = edges_without_a_way_on(mesh, field);
  const auto coincides = [&](const Point& end, double level) {
    return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
      const double a = field[at(edge[0])], b = field[at(edge[1])];
      if ((a >= level) == (b >= level)) return false;
      const auto t = static_cast<double>((level - static_cast<long double>(a)) / (static_cast<long double>(b) - a));
      const Point from = position(mesh, edge[0]), to = position(mesh, edge[1]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = std::abs(from[axis]) + std::abs(to[axis]);
        if (!(std::abs(std::lerp(from[axis], to[axis], t) - end[axis]) <= 1e-14 * size)) return false;
      }
      return true;
    });
  };
  for (std::size_t l = 0; l < line_count(lines); ++l)
    for (const Index p : {lines.offsets[l], lines.offsets[l + 1] - 1})
      if (lines.closed[l] == 0) {
        EXPECT_TRUE(edges.contains({lines.edges[2 * at(p)], lines.edges[2 * at(p) + 1]}) ||
                    coincides(point(lines, at(p)), levels[at(lines.level[l])]))
            << "line " << l << " ends in the open";
      }
}

inline void expect_lawful(const Mesh& mesh, const Isolines& lines, const std::vector<double>& field,
                          const std::vector<double>& levels) {
  expect_consistent_arrays(lines, levels.size());
  expect_points_on_edges(mesh, lines, field, levels);
  expect_real_segments(lines);
}

} // namespace dirichlet
