// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/triangulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "mesh_makers.h"
#include "polygons.h"

namespace dirichlet {
namespace {

/// Two turns out along one side and back along the other.
Polygon spiral(Index count) {
  Polygon polygon;
  for (const double width : {1.0, 0.6})
    for (Index i = 0; i < count; ++i) {
      const double t = static_cast<double>(width == 1.0 ? i : count - 1 - i) / count, angle = 4 * std::numbers::pi * t;
      const double r = 1 + 2 * t + width;
      polygon.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

/// A square with a square hole, and a cut between the two along which the outline runs there and back.
Polygon keyhole() {
  return in_plane({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

/// In the plane y = 0, exactly; twice: in the plane x = 0.
Polygon upright(Polygon polygon) {
  for (Point& p : polygon) p = {p[1], p[2], p[0]};
  return polygon;
}

std::vector<Polygon> simple_polygons() {
  std::vector<Polygon> polygons{
      in_plane({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}), // L
      in_plane(
          {{0, 0}, {7, 0}, {7, 5}, {6, 5}, {6, 1}, {4, 1}, {4, 5}, {3, 5}, {3, 1}, {1, 1}, {1, 5}, {0, 5}}), // comb
      in_plane({{0, 0}, {4, 0}, {2, 1}, {4, 2}, {0, 2}}),                                                    // notch
      in_plane({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {1.5, 0.5}, {1, 3}, {0, 3}}),
      in_plane({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}}), // corners on a straight side
      in_plane({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}),
      around(5, [](Index) { return 1; }),
      around(40, [](Index) { return 1; }),
      around(24, [](Index i) { return i % 2 == 0 ? 2 : 0.5; }),
      spiral(40),
      keyhole(),
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (Index i = 0; i < 100; ++i) polygons.push_back(around(5 + i / 3, [&](Index) { return radius(random); }));
  const std::size_t count = polygons.size();
  for (std::size_t i = 0; i < count; ++i) polygons.push_back(with_split_sides(polygons[i]));
  return polygons;
}

/// Twice the area vector of a, b, c, in units of `size`².
Point area(const Point& a, const Point& b, const Point& c, double size) {
  Point u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = (b[i] - a[i]) / size;
    v[i] = (c[i] - a[i]) / size;
  }
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A split into triangles that all face the polygon's way covers a simple polygon exactly once.
testing::AssertionResult covers(const Polygon& polygon, const std::vector<Index>& triangles) {
  if (const auto result = splits(polygon.size(), triangles); !result) return result;
  double size = 0;
  for (const Point& p : polygon)
    for (std::size_t i = 0; i < 3; ++i) size = std::max(size, std::abs(p[i] - polygon[0][i]));
  Point whole{};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point part = area(polygon[0], polygon[i], polygon[(i + 1) % polygon.size()], size);
    for (std::size_t axis = 0; axis < 3; ++axis) whole[axis] += part[axis];
  }
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const auto corner = [&](std::size_t i) { return polygon[static_cast<std::size_t>(triangles[t + i])]; };
    if (!(dot(area(corner(0), corner(1), corner(2), size), whole) > 1e-12 * dot(whole, whole)))
      return testing::AssertionFailure() << "triangle " << t / 3 << " is flat or folded over";
  }
  return testing::AssertionSuccess();
}

TEST(Triangulation, covers_simple_polygons_once_with_real_triangles) {
  for (const Polygon& polygon : simple_polygons()) EXPECT_TRUE(covers(polygon, triangulate(polygon)));
}

TEST(Triangulation, does_not_depend_on_where_polygons_lie_how_large_they_are_and_where_they_start) {
  for (const Polygon& polygon : simple_polygons()) {
    for (const double scale : {1.0, 1e-160, 1e-290, 1e6, 1e149}) {
      const Polygon moved = tilted(polygon, scale, 0);
      EXPECT_TRUE(covers(moved, triangulate(moved)));
    }
    EXPECT_TRUE(covers(upright(polygon), triangulate(upright(polygon))));
    EXPECT_TRUE(covers(upright(upright(polygon)), triangulate(upright(upright(polygon)))));
    Polygon moved = tilted(polygon, 1, 1e3);
    std::rotate(moved.begin(), moved.begin() + 3, moved.end());
    EXPECT_TRUE(covers(moved, triangulate(moved)));
    std::reverse(moved.begin(), moved.end());
    EXPECT_TRUE(covers(moved, triangulate(moved)));
  }
}

TEST(Triangulation, keeps_triangles_and_splits_quads_from_the_first_corner_to_the_third) {
  const auto soup = makers::grid(1, 1, false);
  const std::vector<Index> quad = soup.faces[0];
  EXPECT_EQ(dirichlet::triangulate(soup.positions, std::vector<Index>{0, 4}, quad),
            (std::vector<Index>{quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]}));
  EXPECT_EQ(triangulate(in_plane({{0, 0}, {1, 0}, {0, 1}})), (std::vector<Index>{0, 1, 2}));
}

TEST(Triangulation, splits_a_quad_the_other_way_where_it_would_fold_or_flatten_it) {
  const std::vector<Index> other{0, 1, 3, 1, 2, 3};
  for (const double scale : {1.0, 1e-160, 1e149}) {
    EXPECT_EQ(triangulate(tilted(in_plane({{4, 0}, {1, 1}, {0, 4}, {0, 0}}), scale)), other);
    EXPECT_EQ(triangulate(tilted(in_plane({{0, 4}, {0, 0}, {4, 0}, {1, 1}}), scale)), other);
  }
  EXPECT_EQ(triangulate(in_plane({{0, 0}, {2, 0}, {4, 0}, {0, 4}})), other);
  EXPECT_EQ(triangulate(in_plane({{0, 0}, {4, 0}, {1, 1}, {0, 4}})), (std::vector<Index>{0, 1, 2, 0, 2, 3}));
}

TEST(Triangulation, splits_bent_and_degenerate_quads_somehow) {
  const Polygon folded{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  const Polygon tetrahedral{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const Polygon ribbon{{0, 0, 0}, {1, 0, 0.1}, {1, 0.02, 0}, {0, 0.02, 0.1}}; // twisted by more than a right angle
  const Polygon hair = in_plane({{0, 0}, {4, 0}, {1, 0}, {1, 3}}), line = in_plane({{0, 0}, {3, 0}, {1, 0}, {2, 0}});
  const Polygon rough = in_plane({{0, 0}, {3, 0}, {1, 1e-7}, {2, -1e-7}}); // a line in single precision
  for (const Polygon& quad : {folded, tetrahedral, ribbon, hair, line, rough, Polygon(4, Point{1, 2, 3})})
    for (const double scale : {1.0, 1e-160, 1e149}) {
      EXPECT_TRUE(splits(4, triangulate(tilted(quad, scale))));
      EXPECT_FALSE(crosses(tilted(quad, scale)));
    }
  std::mt19937 random(1);
  std::normal_distribution<double> height; // as rough as the grid is fine
  for (int i = 0; i < 10'000; ++i) {
    const Polygon quad{{0, 0, height(random)}, {1, 0, height(random)}, {1, 1, height(random)}, {0, 1, height(random)}};
    EXPECT_TRUE(splits(4, triangulate(quad)));
    EXPECT_FALSE(crosses(quad));
  }
}

TEST(Triangulation, splits_polygons_without_an_area_somehow) {
  Polygon line;
  for (const double t : {0.0, 0.1, 0.3, 0.7, 1.0, 0.9, 0.2}) line.push_back({0.1 * t, 0.3 * t, 0.7 * t});
  const Polygon there_and_back = in_plane({{0, 0}, {1, 2}, {3, 1}, {5, 5}, {3, 1}, {1, 2}});
  Polygon rough = line; // in single precision
  for (Point& p : rough)
    for (double& x : p) x = static_cast<double>(static_cast<float>(x));
  for (const Polygon& polygon : {line, tilted(line, 1e-160), rough, there_and_back, Polygon(6, Point{1, 2, 3})})
    EXPECT_TRUE(splits(polygon.size(), triangulate(polygon)));
}

TEST(Triangulation, splits_a_polygon_that_touches_itself) {
  const Polygon at_corner = in_plane({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {0, 0}, {1, 4}, {0, 4}});
  const Polygon at_side = in_plane({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {2, 0}, {1, 4}, {0, 4}});
  for (const Polygon& polygon : {at_corner, at_side, tilted(at_corner), tilted(at_side)})
    EXPECT_TRUE(splits(polygon.size(), triangulate(polygon)));
}

TEST(Triangulation, splits_a_polygon_with_a_hair) {
  const Polygon outside = in_plane({{0, 0}, {2, 0}, {4, 0}, {2, 0}, {2, 2}, {0, 2}});
  const Polygon inside = in_plane({{0, 0}, {4, 0}, {4, 2}, {1, 1}, {4, 2}, {4, 4}, {0, 4}});
  EXPECT_TRUE(splits(outside.size(), triangulate(outside)));
  EXPECT_TRUE(covers(inside, triangulate(inside)));
}

TEST(Triangulation, follows_a_bent_polygon) {
  Polygon bent = around(10, [](Index i) { return i % 2 == 0 ? 1 : 0.7; });
  for (std::size_t i = 0; i < 10; ++i) bent[i][2] = i % 2 == 0 ? 0.4 : -0.4;
  EXPECT_TRUE(covers(bent, triangulate(bent)));
  EXPECT_TRUE(covers(tilted(bent), triangulate(tilted(bent)))); // not along an axis, but along its area vector
  Polygon skew = around(6, [](Index) { return 1; });
  for (std::size_t i = 0; i < 6; ++i) skew[i][2] = i % 2 == 0 ? 5e3 : -5e3;
  EXPECT_TRUE(splits(6, triangulate(skew)));
  EXPECT_TRUE(splits(6, triangulate(tilted(skew))));
}

TEST(Triangulation, manages_polygons_of_thousands_of_corners) {
  constexpr Index kCount = 5000;
  for (const Polygon& polygon :
       {around(kCount, [](Index) { return 1; }), around(kCount, [](Index i) { return i % 2 == 0 ? 1 : 0.9; }),
        around(kCount, [](Index i) { return 1 + 0.5 * std::sin(0.1 * i); }), spiral(kCount / 2)})
    EXPECT_TRUE(splits(polygon.size(), triangulate(polygon)));
}

TEST(Triangulation, cuts_a_convex_polygon_into_no_fan) {
  const auto triangles = triangulate(around(64, [](Index) { return 1; }));
  std::vector<int> uses(64, 0);
  for (const Index corner : triangles) ++uses[static_cast<std::size_t>(corner)];
  EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 12); // 2 log2 64
}

TEST(Triangulation, cuts_a_band_to_and_fro) {
  Polygon band;
  for (int i = 0; i < 500; ++i) band.push_back({i / 100.0, 0, 0});
  for (int i = 499; i >= 0; --i) band.push_back({i / 100.0, 1, 0});
  const auto triangles = triangulate(band);
  double longest = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const auto along = [&](std::size_t i) { return band[static_cast<std::size_t>(triangles[t + i])][0]; };
    const auto [low, high] = std::minmax({along(0), along(1), along(2)});
    longest = std::max(longest, high - low);
  }
  EXPECT_LT(longest, 0.03);
}

TEST(Triangulation, lists_the_triangles_of_face_after_face) {
  const auto soup = makers::copies(makers::grid(60, 60, false), 6); // enough for two threads
  std::vector<Index> offsets{0}, corners, expected;
  for (const auto& q : soup.faces) {
    corners.insert(corners.end(), q.begin(), q.end());
    offsets.push_back(static_cast<Index>(corners.size()));
    expected.insert(expected.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
  }
  EXPECT_EQ(dirichlet::triangulate(soup.positions, offsets, corners), expected);
}

} // namespace
} // namespace dirichlet
