// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/isolines.h"

#include <numbers>

#include <gtest/gtest.h>

#include "dirichlet/levels.h"
#include "line_checks.h"
#include "mesh_makers.h"
#include "parallel.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

const std::vector<double> kLevels{0.1, 0.35, 0.5, 0.77, 0.9};

std::vector<PolygonSoup> closed_surfaces() {
  return {makers::torus(9, 7),      makers::torus(9, 7, false),  makers::sphere(5, 8),
          makers::tetrahedron(),    makers::klein_bottle(8, 10), makers::turned_over(makers::torus(9, 7), 2),
          makers::torus(3, 3, true)};
}

std::vector<PolygonSoup> bordered_surfaces() {
  return {makers::grid(8, 6), makers::grid(8, 6, false), makers::moebius(9), makers::book(2, 6)};
}

/// Whether the point is on an edge with one face, or at an end of such an edge.
bool on_border(const Mesh& mesh, const Isolines& lines, std::size_t p) {
  const auto loops = mesh.border_loops();
  const std::set<Index> border(loops.vertices.begin(), loops.vertices.end());
  const Index a = lines.edges[2 * p], b = lines.edges[2 * p + 1];
  return (border.contains(a) && (border.contains(b) || lines.t[p] == 0)) || (border.contains(b) && lines.t[p] == 1);
}

TEST(Isolines, are_all_closed_on_a_closed_surface) {
  for (const PolygonSoup& soup : closed_surfaces())
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto mesh = make_mesh(soup);
      const auto field = random_numbers(*mesh, seed);
      const Isolines lines = extract_isolines(*mesh, field, kLevels);
      expect_lawful(*mesh, lines, field, kLevels);
      EXPECT_TRUE(all_closed(lines));
      EXPECT_EQ(lines.t.size(), crossed_triangles(*mesh, field, kLevels));
    }
}

TEST(Isolines, are_closed_or_end_on_the_border) {
  for (const PolygonSoup& soup : bordered_surfaces())
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto mesh = make_mesh(soup);
      const auto field = random_numbers(*mesh, seed);
      const Isolines lines = extract_isolines(*mesh, field, kLevels);
      expect_lawful(*mesh, lines, field, kLevels);
      EXPECT_FALSE(all_closed(lines));
      for (std::size_t l = 0; l < line_count(lines); ++l) {
        if (lines.closed[l] == 1) continue;
        EXPECT_TRUE(on_border(*mesh, lines, at(lines.offsets[l])));
        EXPECT_TRUE(on_border(*mesh, lines, at(lines.offsets[l + 1]) - 1));
      }
    }
}

TEST(Isolines, cross_every_edge_that_has_the_level_between_its_ends_once) {
  for (const PolygonSoup& soup : {makers::torus(9, 7), makers::grid(8, 6), makers::klein_bottle(8, 10)}) {
    const auto mesh = make_mesh(soup);
    const auto field = random_numbers(*mesh, 1);
    std::multiset<std::array<Index, 3>> expected, crossed;
    const auto& edges = mesh->triangulated().connectivity().edges;
    for (Index k = 0; k < 5; ++k)
      for (std::size_t e = 0; e < edges.size(); e += 2)
        if ((field[at(edges[e])] >= kLevels[at(k)]) != (field[at(edges[e + 1])] >= kLevels[at(k)]))
          expected.insert({k, edges[e], edges[e + 1]});
    const Isolines lines = extract_isolines(*mesh, field, kLevels);
    for (std::size_t l = 0; l < line_count(lines); ++l)
      for (auto p = at(lines.offsets[l]); p < at(lines.offsets[l + 1]); ++p)
        crossed.insert({lines.level[l], lines.edges[2 * p], lines.edges[2 * p + 1]});
    EXPECT_EQ(crossed, expected);
  }
}

TEST(Isolines, of_whole_number_fields_have_real_segments_and_even_degrees) {
  const std::vector<double> levels{0, 1, 2, 3, 0.5};
  for (const PolygonSoup& soup : closed_surfaces())
    for (unsigned seed = 0; seed < 50; ++seed) {
      const auto mesh = make_mesh(soup);
      const auto field = random_whole_numbers(*mesh, 3, seed);
      const Isolines lines = extract_isolines(*mesh, field, levels);
      expect_lawful(*mesh, lines, field, levels);
      EXPECT_TRUE(all_closed(lines));
      std::map<std::pair<Index, Point>, int> degree;
      for (std::size_t l = 0; l < line_count(lines); ++l) {
        const auto points = line(lines, l);
        for (std::size_t i = 0; i + 1 < points.size() + lines.closed[l]; ++i) {
          ++degree[{lines.level[l], points[i]}];
          ++degree[{lines.level[l], points[(i + 1) % points.size()]}];
        }
      }
      for (const auto& [place, count] : degree) EXPECT_EQ(count % 2, 0);
    }
}

TEST(Isolines, have_higher_values_on_their_left) {
  const auto mesh = make_mesh(makers::grid(20, 20));
  const auto left_of = [](const Point& a, const Point& b, double x, double y) {
    return (b[0] - a[0]) * y - (b[1] - a[1]) * x;
  };
  const auto slope = sample(*mesh, [](double x, double y, double) { return 0.3 * x - 0.7 * y; });
  const Isolines lines = extract_isolines(*mesh, slope, std::vector<double>{-3.3, 0.1});
  ASSERT_EQ(line_count(lines), 2U);
  for (std::size_t l = 0; l < 2; ++l) {
    const auto points = line(lines, l);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_GT(left_of(points[i], points[i + 1], 0.3, -0.7), 0);
  }
}

TEST(Isolines, run_the_other_way_on_a_surface_turned_over) {
  const auto soup = makers::torus(9, 7);
  const auto mesh = make_mesh(soup), turned = make_mesh(makers::turned_over(soup));
  const auto field = random_numbers(*mesh, 3);
  const Isolines lines = extract_isolines(*mesh, field, kLevels), back = extract_isolines(*turned, field, kLevels);
  ASSERT_EQ(line_count(lines), line_count(back));
  for (std::size_t l = 0; l < line_count(lines); ++l) {
    auto there = line(lines, l), reversed = line(back, l);
    std::reverse(reversed.begin(), reversed.end());
    std::rotate(there.begin(), std::min_element(there.begin(), there.end()), there.end());
    std::rotate(reversed.begin(), std::min_element(reversed.begin(), reversed.end()), reversed.end());
    EXPECT_EQ(there, reversed);
  }
}

TEST(Isolines, run_as_the_first_triangle_says_where_there_is_no_outside) {
  const auto mesh = make_mesh(makers::turned_over(makers::grid(6, 6), 3)); // triangle 0 turned over as well
  const auto field = sample(*mesh, [](double x, double, double) { return x; });
  const Isolines lines = extract_isolines(*mesh, field, std::vector<double>{0.5, 1.5});
  ASSERT_EQ(line_count(lines), 2U);
  EXPECT_EQ(line(lines, 0).front()[1], 0); // upwards: x is higher on the left seen from below
  EXPECT_EQ(line(lines, 0).back()[1], 6);
  EXPECT_EQ(line(lines, 1).front()[1], 6); // downwards: its first triangle, 2, is as it was
}

TEST(Isolines, are_as_many_level_sets_as_levels_on_a_monotone_strip) {
  const auto mesh = make_mesh(makers::grid(20, 3));
  const auto field = sample(*mesh, [](double x, double, double) { return x; });
  for (const Index count : {1, 2, 7, 13, 100, 10000}) {
    const auto levels = even_levels(0, 20, count);
    const Isolines lines = extract_isolines(*mesh, field, levels);
    ASSERT_EQ(line_count(lines), at(count));
    for (std::size_t l = 0; l < line_count(lines); ++l) {
      EXPECT_EQ(at(lines.level[l]), l);
      EXPECT_NEAR(lines.length[l], 3, 1e-12);
    }
  }
}

TEST(Isolines, of_squared_radius_have_lengths_that_converge_to_the_circle_at_second_order) {
  const auto error = [](Index n) {
    const auto mesh = make_mesh(makers::grid(n, n));
    const double middle = 0.5 * n, radius = 0.37 * n;
    const auto field = sample(
        *mesh, [=](double x, double y, double) { return (x - middle) * (x - middle) + (y - middle) * (y - middle); });
    const Isolines lines = extract_isolines(*mesh, field, std::vector<double>{radius * radius});
    EXPECT_EQ(line_count(lines), 1U);
    EXPECT_TRUE(all_closed(lines));
    return std::abs(lines.length[0] / (2 * std::numbers::pi * radius) - 1);
  };
  EXPECT_LT(error(200), 1e-4);
  EXPECT_GT(std::log2(error(40) / error(160)), 2 * 1.8);
}

TEST(Isolines, are_the_same_together_as_level_by_level_in_any_order) {
  const auto mesh = make_mesh(makers::sphere(20, 30));
  const auto field = random_numbers(*mesh, 5);
  const std::vector<double> levels{0.7, 0.2, 0.7, 0.5, -3, 0.2};
  const Isolines together = extract_isolines(*mesh, field, levels);
  std::size_t l = 0;
  for (const Index k : {0, 1, 3}) { // the rest repeat one of these, or cross nothing
    const Isolines alone = extract_isolines(*mesh, field, std::vector<double>{levels[at(k)]});
    for (std::size_t i = 0; i < line_count(alone); ++i, ++l) {
      ASSERT_LT(l, line_count(together));
      EXPECT_EQ(together.level[l], k);
      EXPECT_EQ(line(together, l), line(alone, i));
    }
  }
  EXPECT_EQ(l, line_count(together));
}

TEST(Isolines, of_many_copies_are_copies_however_many_threads_share_them) {
  constexpr Index kCopies = 400; // enough for every stage to be shared
  const auto soup = makers::torus(20, 10);
  const auto mesh = make_mesh(soup), many = make_mesh(makers::copies(soup, kCopies));
  const auto field = random_numbers(*mesh, 7);
  std::vector<double> fields;
  for (Index k = 0; k < kCopies; ++k) fields.insert(fields.end(), field.begin(), field.end());
  const Isolines one = extract_isolines(*mesh, field, kLevels), all = extract_isolines(*many, fields, kLevels);
  thread_limit = 1;
  const Isolines alone = extract_isolines(*many, fields, kLevels);
  thread_limit = 0;
  EXPECT_EQ(all.points, alone.points);
  EXPECT_EQ(all.offsets, alone.offsets);
  expect_consistent_arrays(all, kLevels.size());
  ASSERT_EQ(line_count(all), line_count(one) * at(kCopies));
  std::size_t l = 0;
  for (std::size_t first = 0, last = 0; first < line_count(one); first = last) { // the lines of one level
    while (last < line_count(one) && one.level[last] == one.level[first]) ++last;
    for (Index k = 0; k < kCopies; ++k)
      for (std::size_t i = first; i < last; ++i, ++l) {
        ASSERT_EQ(all.level[l], one.level[i]);
        ASSERT_EQ(all.length[l], one.length[i]);
        ASSERT_EQ(line(all, l), line(one, i));
      }
  }
}

} // namespace
} // namespace dirichlet
