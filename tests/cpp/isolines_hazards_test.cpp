// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "dirichlet/isolines.h"
#include "line_checks.h"
#include "mesh_makers.h"
#include "refusal.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using makers::PolygonSoup;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Levels = std::vector<double>;

/// 0 on a 6 × 6 grid but for some vertices.
std::vector<double> grid_field(std::initializer_list<std::pair<Index, Index>> places, double value) {
  std::vector<double> field(49, 0);
  for (const auto& [i, j] : places) field[at(i + 7 * j)] = value;
  return field;
}

TEST(IsolineHazards, a_level_at_a_column_of_vertices_runs_through_each_of_them_once) {
  const auto mesh = make_mesh(makers::grid(5, 4));
  const auto field = sample(*mesh, [](double x, double, double) { return x; });
  const Isolines lines = extract_isolines(*mesh, field, Levels{3});
  ASSERT_EQ(line_count(lines), 1U);
  EXPECT_EQ(line(lines, 0), (std::vector<Point>{{3, 4, 0}, {3, 3, 0}, {3, 2, 0}, {3, 1, 0}, {3, 0, 0}}));
  EXPECT_EQ(lines.length[0], 4);
}

TEST(IsolineHazards, a_level_through_one_vertex_passes_it_once) {
  const auto mesh = make_mesh(makers::grid(4, 4));
  const auto field = sample(*mesh, [](double x, double y, double) { return x + 0.25 * y; });
  const Isolines lines = extract_isolines(*mesh, field, Levels{2.5}); // (2, 2) and no other vertex
  ASSERT_EQ(line_count(lines), 1U);
  const auto points = line(lines, 0);
  EXPECT_EQ(std::count(points.begin(), points.end(), Point{2, 2, 0}), 1);
  expect_lawful(*mesh, lines, field, {2.5});
}

TEST(IsolineHazards, a_plateau_lies_above_and_the_line_runs_along_its_rim) {
  const auto mesh = make_mesh(makers::grid(6, 6));
  const auto field = grid_field({{2, 2}, {3, 2}, {4, 2}, {2, 3}, {3, 3}, {4, 3}, {2, 4}, {3, 4}, {4, 4}}, 1);
  const Isolines lines = extract_isolines(*mesh, field, Levels{1});
  ASSERT_EQ(line_count(lines), 1U);
  EXPECT_TRUE(all_closed(lines));
  EXPECT_EQ(lines.t.size(), 8U);
  EXPECT_EQ(lines.length[0], 8);
  EXPECT_EQ(line_count(extract_isolines(*mesh, field, Levels{0})), 0U);
}

TEST(IsolineHazards, a_plateau_of_one_edge_is_a_closed_line_there_and_back) {
  const auto mesh = make_mesh(makers::grid(6, 6));
  const auto field = grid_field({{2, 3}, {3, 3}}, 1);
  const Isolines lines = extract_isolines(*mesh, field, Levels{1});
  ASSERT_EQ(line_count(lines), 1U);
  EXPECT_TRUE(all_closed(lines));
  EXPECT_EQ(lines.t.size(), 2U);
  EXPECT_EQ(lines.length[0], 2);
}

TEST(IsolineHazards, a_level_at_a_single_highest_vertex_leaves_nothing) {
  const auto mesh = make_mesh(makers::grid(6, 6));
  for (const auto& [i, j] : {std::pair{3, 3}, std::pair{0, 0}, std::pair{6, 2}}) {
    const Isolines lines = extract_isolines(*mesh, grid_field({{i, j}}, 1), Levels{1});
    EXPECT_EQ(line_count(lines), 0U);
    EXPECT_EQ(lines.offsets, std::vector<Index>{0});
    EXPECT_TRUE(lines.points.empty());
  }
}

TEST(IsolineHazards, levels_at_the_lowest_value_or_out_of_range_and_no_levels_leave_nothing) {
  const auto mesh = make_mesh(makers::grid(5, 4));
  const auto field = sample(*mesh, [](double x, double, double) { return x; });
  EXPECT_EQ(line_count(extract_isolines(*mesh, field, Levels{0, -2, 5.5, 1e308, -1e308})), 0U);
  EXPECT_EQ(extract_isolines(*mesh, field, {}).offsets, std::vector<Index>{0});
}

TEST(IsolineHazards, of_equal_levels_the_first_carries_the_lines) {
  const auto mesh = make_mesh(makers::grid(5, 4));
  const auto field = sample(*mesh, [](double x, double, double) { return x; });
  Levels levels;
  for (int i = 0; i < 100; ++i) levels.insert(levels.end(), {3.5, 1.5, 2.5, i % 2 == 0 ? 0.0 : -0.0});
  EXPECT_EQ(extract_isolines(*mesh, field, levels).level, (std::vector<Index>{0, 1, 2}));
}

TEST(IsolineHazards, undefined_vertices_cut_lines_open_and_are_not_touched) {
  const auto mesh = make_mesh(makers::grid(6, 6));
  auto field = sample(*mesh, [](double x, double, double) { return x; });
  const Index hole = 3 + 3 * 7;
  field[at(hole)] = kNan;
  const Isolines lines = extract_isolines(*mesh, field, Levels{2.5, 4.5});
  EXPECT_EQ(lines.level, (std::vector<Index>{0, 0, 1}));
  EXPECT_EQ(std::count(lines.edges.begin(), lines.edges.end(), hole), 0);
  expect_real_segments(lines);
  EXPECT_EQ(line_count(extract_isolines(*mesh, std::vector<double>(49, kNan), Levels{1})), 0U);
}

TEST(IsolineHazards, lines_end_where_three_or_more_sheets_meet_at_the_same_point) {
  for (const Index pages : {3, 4, 12}) {
    const auto mesh = make_mesh(makers::book(pages, 4));
    const auto field = sample(*mesh, [](double, double, double z) { return z; });
    const Isolines lines = extract_isolines(*mesh, field, Levels{1.3});
    ASSERT_EQ(line_count(lines), at(pages));
    for (std::size_t l = 0; l < line_count(lines); ++l) {
      EXPECT_EQ(lines.closed[l], 0);
      const auto points = line(lines, l);
      EXPECT_EQ(std::count(points.begin(), points.end(), Point{0, 0, 1.3}), 1);
      EXPECT_TRUE(points.front() == (Point{0, 0, 1.3}) || points.back() == (Point{0, 0, 1.3}));
    }
  }
}

TEST(IsolineHazards, lines_stay_closed_where_two_diagonals_join_the_same_vertices) {
  const PolygonSoup pillow{{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {{0, 1, 2, 3}, {0, 3, 2, 1}}};
  const PolygonSoup doublet{{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.7, 0.3, 1}, // quads 0123 and 0321 around 4
                            {{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 4, 2, 1}}};
  const PolygonSoup mixed{{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.7, 0.3, 1}, // the diagonal 0 2 is an edge besides
                          {{0, 1, 2, 3}, {0, 2, 1}, {0, 3, 4}, {3, 2, 4}, {2, 0, 4}}};
  for (const PolygonSoup& soup : {pillow, doublet, mixed})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const auto mesh = make_mesh(soup);
      const auto field = random_numbers(*mesh, seed);
      const Isolines lines = extract_isolines(*mesh, field, Levels{0.3, 0.5, 0.7});
      expect_lawful(*mesh, lines, field, {0.3, 0.5, 0.7});
      EXPECT_TRUE(all_closed(lines));
      EXPECT_EQ(lines.t.size(), crossed_triangles(*mesh, field, {0.3, 0.5, 0.7}));
    }
}

TEST(IsolineHazards, concave_quads_are_crossed_inside) {
  const auto mesh = make_mesh({{0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0}, {{1, 2, 3, 0}}});
  const Isolines lines = extract_isolines(*mesh, std::vector<double>{0, 1, 2, 1}, Levels{0.9});
  ASSERT_EQ(line_count(lines), 1U);
  for (const auto& p : line(lines, 0)) EXPECT_TRUE(p[0] <= 1 || p[1] <= 1);
}

TEST(IsolineHazards, huge_values_do_not_overflow) {
  const auto mesh = make_mesh(makers::grid(1, 1));
  for (const double huge : {1e300, std::numeric_limits<double>::max()}) {
    const Isolines lines = extract_isolines(*mesh, Levels{-huge, huge, -huge, huge}, Levels{0, huge / 2, huge});
    ASSERT_EQ(line_count(lines), 3U);
    EXPECT_EQ(line(lines, 0).front()[0], 0.5);
    EXPECT_EQ(line(lines, 1).front()[0], 0.75);
    EXPECT_EQ(line(lines, 2).front()[0], 1);
  }
}

TEST(IsolineHazards, values_one_ulp_apart_have_their_line_at_the_upper_vertices) {
  const auto mesh = make_mesh(makers::grid(1, 1));
  for (const double low : {1.0, 0.0, 1e300}) {
    const double high = std::nextafter(low, kInfinity);
    const Isolines lines = extract_isolines(*mesh, Levels{low, high, low, high}, Levels{low, high});
    ASSERT_EQ(line_count(lines), 1U);
    EXPECT_EQ(line(lines, 0), (std::vector<Point>{{1, 1, 0}, {1, 0, 0}}));
  }
}

TEST(IsolineHazards, lines_of_tiny_and_huge_meshes_have_lengths) {
  for (const double scale : {1e-300, 1e-160, 1e149}) {
    auto soup = makers::grid(4, 2);
    for (double& x : soup.positions) x *= scale;
    const auto mesh = make_mesh(soup);
    const auto field = sample(*mesh, [=](double x, double, double) { return x / scale; });
    const Isolines lines = extract_isolines(*mesh, field, Levels{1.5});
    ASSERT_EQ(line_count(lines), 1U);
    EXPECT_NEAR(lines.length[0] / scale, 2, 1e-12);
  }
}

TEST(IsolineHazards, bad_numbers_are_refused_by_place) {
  const auto mesh = make_mesh(makers::grid(2, 2));
  std::vector<double> field(9, 1);
  EXPECT_REFUSED(extract_isolines(*mesh, std::vector<double>(8, 1), Levels{1}), InputError, "8 values", "9 vertices");
  EXPECT_REFUSED(extract_isolines(*mesh, field, Levels{1, kNan, kInfinity}), InputError, "level 1", "1 more level");
  field[5] = -kInfinity;
  field[7] = kInfinity;
  EXPECT_REFUSED(extract_isolines(*mesh, field, Levels{1}), InputError, "vertex 5", "1 more value");
}

TEST(IsolinesRefuse, more_crossings_than_can_be_counted) {
  const auto mesh = make_mesh(makers::torus(150, 140)); // 42,000 triangles
  std::vector<double> field(150 * 140);
  for (std::size_t v = 0; v < field.size(); ++v) field[v] = v % 2 == 0 ? 0 : 1;
  std::vector<double> levels(40'000);
  for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = static_cast<double>(k + 1) / 50'000;
  EXPECT_REFUSED(extract_isolines(*mesh, field, levels), InputError, "cross the triangles", "times");
}

} // namespace
} // namespace dirichlet
