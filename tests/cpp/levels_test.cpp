// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/levels.h"

#include <limits>

#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "line_checks.h"
#include "mesh_makers.h"
#include "refusal.h"
#include "strips.h"

namespace dirichlet {
namespace {

using makers::make_mesh;
using Levels = std::vector<double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHuge = std::numeric_limits<double>::max();

bool strictly_ascending_inside(double low, double high, const Levels& levels) {
  return low < levels.front() && levels.back() < high &&
         std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) == levels.end();
}

double ulps_above(double x, int count) {
  while (count-- > 0) x = std::nextafter(x, kInfinity);
  return x;
}

TEST(EvenLevels, are_the_middles_of_equal_parts_of_the_window) {
  EXPECT_EQ(even_levels(0, 10, 5), (Levels{1, 3, 5, 7, 9}));
  EXPECT_EQ(even_levels(-3, 1, 1), (Levels{-1}));
  EXPECT_EQ(even_levels(0.25, 0.75, 2), (Levels{0.375, 0.625}));
  EXPECT_NEAR(even_levels(-kHuge, kHuge, 2)[0] / kHuge, -0.5, 1e-15);
}

TEST(EvenLevels, are_exactly_as_many_as_asked_all_different_and_inside) {
  for (const auto& [low, high] :
       {std::pair{0.0, 1.0}, {-kHuge, kHuge}, {1e300, kHuge}, {0.0, 1e-320}, {-1e-310, 2e-310}})
    for (const Index count : {1, 2, 10, 1000}) {
      const Levels levels = even_levels(low, high, count);
      EXPECT_EQ(levels.size(), at(count));
      EXPECT_TRUE(strictly_ascending_inside(low, high, levels)) << low << " " << high << " " << count;
    }
}

TEST(EvenLevels, use_every_double_of_a_window_that_has_just_enough) {
  for (const double low : {1.0, -1.0, 0.0, 1e300})
    EXPECT_EQ(
        even_levels(low, ulps_above(low, 6), 5),
        (Levels{ulps_above(low, 1), ulps_above(low, 2), ulps_above(low, 3), ulps_above(low, 4), ulps_above(low, 5)}));
}

TEST(EvenLevels, make_room_for_each_other_where_doubles_get_sparser) {
  const double u =
      std::numeric_limits<double>::epsilon() / 2; // between the doubles below 1; above there are half as many
  EXPECT_EQ(even_levels(1 - 4 * u, 1 + 4 * u, 5), (Levels{1 - 3 * u, 1 - 2 * u, 1 - u, 1, 1 + 2 * u}));
  EXPECT_EQ(even_levels(-1 - 4 * u, -1 + 4 * u, 5), (Levels{-1 - 2 * u, -1, -1 + u, -1 + 2 * u, -1 + 3 * u}));
}

TEST(EvenLevels, stay_above_the_lower_end_of_a_window_with_too_few_doubles) {
  const double high = ulps_above(1, 1);
  EXPECT_EQ(even_levels(1, high, 3), (Levels{high, high, high}));
  for (const double level : even_levels(1, ulps_above(1, 3), 100)) EXPECT_TRUE(1 < level && level <= ulps_above(1, 3));
}

TEST(EvenLevels, of_no_number_or_no_window_are_refused) {
  EXPECT_REFUSED(even_levels(0, 1, 0), InputError, "levels is 0");
  EXPECT_REFUSED(even_levels(0, 1, -1), InputError, "levels is -1");
  EXPECT_REFUSED(even_levels(0, 1, 2'000'000'000), InputError, "2000000000", "1000000");
  EXPECT_REFUSED(even_levels(1, 1, 3), InputError, "from 1 to 1 is empty");
  EXPECT_REFUSED(even_levels(2, 1, 3), InputError, "from 2 to 1 is empty");
  EXPECT_REFUSED(even_levels(kNan, 1, 3), InputError, "nan");
  EXPECT_REFUSED(even_levels(0, kInfinity, 3), InputError, "inf");
}

TEST(SteppedLevels, are_the_multiples_of_the_step_strictly_inside_the_window) {
  EXPECT_EQ(stepped_levels(0, 2, 0.5, 0), (Levels{0.5, 1, 1.5}));
  EXPECT_EQ(stepped_levels(-1.2, 0.7, 0.5, 0), (Levels{-1, -0.5, 0, 0.5}));
  EXPECT_EQ(stepped_levels(0.1, 0.4, 1, 0), Levels{});
}

TEST(SteppedLevels, move_by_one_step_as_the_phase_goes_from_0_to_1) {
  EXPECT_EQ(stepped_levels(0, 2, 0.5, 0.5), (Levels{0.25, 0.75, 1.25, 1.75}));
  for (const double phase : {1.0, -1.0, 7.0, 1e300}) EXPECT_EQ(stepped_levels(0, 2, 0.5, phase), (Levels{0.5, 1, 1.5}));
  EXPECT_EQ(stepped_levels(0, 2, 0.5, -0.25), stepped_levels(0, 2, 0.5, 0.75));
}

TEST(SteppedLevels, are_different_and_inside_far_from_0_too) {
  for (const auto& [low, width, step] : {std::array{1e16, 40.0, 1.5},
                                         {-1e16, 40.0, 0.3},
                                         {1e300, 1e290, 1e284},
                                         {-kHuge, kHuge, 1e305},
                                         {0.3, 0.4, 1e-6},
                                         {1e-310, 1e-310, 1e-313}}) {
    const double high = low + width;
    const Levels levels = stepped_levels(low, high, step, 0.3);
    ASSERT_FALSE(levels.empty());
    EXPECT_TRUE(strictly_ascending_inside(low, high, levels)) << low;
  }
  EXPECT_EQ(stepped_levels(-kHuge, kHuge, 1e308, 0), (Levels{-1e308, 0, 1e308}));
}

TEST(SteppedLevels, of_no_step_no_window_or_too_many_are_refused) {
  EXPECT_REFUSED(stepped_levels(0, 1, 0, 0), InputError, "step is 0");
  EXPECT_REFUSED(stepped_levels(0, 1, -1, 0), InputError, "step is -1");
  EXPECT_REFUSED(stepped_levels(0, 1, kNan, 0), InputError, "step is nan");
  EXPECT_REFUSED(stepped_levels(0, 1, kInfinity, 0), InputError, "step is inf");
  EXPECT_REFUSED(stepped_levels(0, 1, 0.1, kInfinity), InputError, "phase is inf");
  EXPECT_REFUSED(stepped_levels(1, 0, 0.1, 0), InputError, "empty");
  EXPECT_REFUSED(stepped_levels(0, 1, 1e-7, 0), InputError, "more than 1000000");
  EXPECT_REFUSED(stepped_levels(0, 1, 1e-300, 0), InputError, "more than 1000000");
  EXPECT_EQ(stepped_levels(0, 1'000'000.5, 1, 0).size(), 1'000'000U);
  EXPECT_REFUSED(stepped_levels(-0.5, 1'000'000.4, 1, 0), InputError, "more than 1000000");
}

/// From x = 0 to 1: 4000 columns of two vertices in a hundredth of its length, and 5 to 60 in the rest, where it is as
/// wide as random numbers say.
std::shared_ptr<const Mesh> uneven_strip(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(0, 1), dense(0.3, 0.31), width(0.5, 1.5);
  std::vector<double> columns{0, 1};
  for (int i = 0; i < 4000; ++i) columns.push_back(dense(random));
  for (int i = std::uniform_int_distribution(5, 60)(random); i > 0; --i) columns.push_back(anywhere(random));
  std::sort(columns.begin(), columns.end());
  makers::PolygonSoup strip;
  for (const double x : columns) {
    const double y = x > 0.3 && x < 0.31 ? 1 : width(random);
    strip.positions.insert(strip.positions.end(), {x, -y, 0, x, y, 0});
  }
  for (Index v = 0; v + 3 < 2 * static_cast<Index>(columns.size()); v += 2) {
    strip.faces.push_back({v, v + 2, v + 3});
    strip.faces.push_back({v, v + 3, v + 1});
  }
  return make_mesh(strip);
}

TEST(EqualAreaLevels, ascend_and_cut_equal_strips_however_unevenly_vertices_are_spread) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto mesh = uneven_strip(seed);
    const auto field = sample(*mesh, [](double x, double, double) { return x; });
    Levels levels = equal_area_levels(*mesh, field, 13);
    ASSERT_TRUE(strictly_ascending_inside(0, 1, levels)) << seed;
    levels.push_back(1);
    const Levels areas = measure_strips(*mesh, field, levels).area;
    for (std::size_t k = 0; k < 13; ++k)
      EXPECT_NEAR(areas[k] / areas.back(), (static_cast<double>(k) + 1) / 14, 1e-9) << seed;
  }
}

TEST(EqualDistanceLevels, are_as_even_as_a_linear_field_however_unevenly_vertices_are_spread) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto mesh = uneven_strip(seed);
    const auto field = sample(*mesh, [](double x, double, double) { return x; });
    Levels levels = equal_distance_levels(*mesh, field, 40, 0, 1);
    levels.insert(levels.begin(), 0);
    levels.push_back(1);
    for (std::size_t k = 0; k < 41; ++k) EXPECT_NEAR(41 * (levels[k + 1] - levels[k]), 1, 0.02) << seed;
  }
}

TEST(LevelThroughPoint, is_the_value_of_a_linear_field_below_the_point) {
  for (const bool triangles : {true, false}) {
    const auto mesh = make_mesh(makers::grid(7, 5, triangles));
    const auto field = sample(*mesh, [](double x, double y, double) { return 2 * x - 3 * y; });
    for (const Point& p : {Point{3.3, 2.1, 0}, Point{0.9, 4.2, 5}, Point{6.5, 0.01, -0.3}})
      EXPECT_NEAR(level_through_point(*mesh, field, p), 2 * p[0] - 3 * p[1], 1e-12);
    EXPECT_NEAR(level_through_point(*mesh, field, {8, -1, 2}), 14, 1e-12); // nearest: the corner (7, 0)
    EXPECT_NEAR(level_through_point(*mesh, field, {3.4, -2, 1}), 6.8, 1e-12);
  }
}

TEST(LevelThroughPoint, is_the_mean_of_the_corners_in_the_middle_of_a_triangle) {
  const auto mesh = make_mesh(makers::torus(40, 20));
  const auto field = random_numbers(*mesh, 2);
  std::mt19937 random(4);
  std::uniform_int_distribution<Index> triangle(0, mesh->face_count() - 1);
  for (int i = 0; i < 50; ++i) {
    Point middle{};
    const auto corners = mesh->corners().subspan(3 * at(triangle(random)), 3);
    for (const Index v : corners)
      for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += position(*mesh, v)[axis] / 3;
    const double mean = (field[at(corners[0])] + field[at(corners[1])] + field[at(corners[2])]) / 3;
    EXPECT_NEAR(level_through_point(*mesh, field, middle), mean, 1e-12);
  }
}

TEST(LevelThroughPoint, is_the_exact_value_at_a_vertex_even_next_to_undefined_ones) {
  const auto mesh = make_mesh(makers::sphere(9, 12));
  auto field = random_numbers(*mesh, 3);
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    EXPECT_EQ(level_through_point(*mesh, field, position(*mesh, v)), field[at(v)]);
  field[1] = kNan;
  EXPECT_EQ(level_through_point(*mesh, field, position(*mesh, 0)), field[0]);
}

TEST(LevelThroughPoint, is_found_at_any_scale_and_on_flat_triangles) {
  for (const double scale : {1e-300, 1e-160, 1e-6, 1e149}) {
    auto soup = makers::grid(7, 5);
    for (double& x : soup.positions) x *= scale;
    const auto mesh = make_mesh(soup);
    const auto field = sample(*mesh, [=](double x, double, double) { return x / scale; });
    EXPECT_NEAR(level_through_point(*mesh, field, {3.3 * scale, 2.1 * scale, 0}), 3.3, 1e-9);
  }
  const auto needle = make_mesh({{0, 0, 0, 1, 0, 0, 2, 0, 0}, {{0, 1, 2}}});
  EXPECT_NEAR(level_through_point(*needle, Levels{0, 1, 2}, {1.7, 1, 0}), 1.7, 1e-12);
  const auto dot = make_mesh({{1, 1, 1, 1, 1, 1, 1, 1, 1}, {{0, 1, 2}}});
  EXPECT_EQ(level_through_point(*dot, Levels{5, 5, 5}, {0, 0, 0}), 5);
}

TEST(LevelThroughPoint, stays_between_huge_values) {
  const auto mesh = make_mesh(makers::grid(1, 1));
  EXPECT_EQ(level_through_point(*mesh, Levels(4, kHuge), {0.7, 0.2, 0}), kHuge);
  EXPECT_EQ(level_through_point(*mesh, Levels{-kHuge, kHuge, -kHuge, kHuge}, {0.5, 0.25, 0}), 0);
}

TEST(LevelThroughPoint, is_refused_where_the_field_is_undefined_and_for_bad_numbers) {
  const auto mesh = make_mesh(makers::grid(2, 2));
  Levels field(9, 1);
  EXPECT_REFUSED(level_through_point(*mesh, Levels(4, 1), {0, 0, 0}), InputError, "4 values", "9 vertices");
  EXPECT_REFUSED(level_through_point(*mesh, field, {0, kNan, 0}), InputError, "nan");
  field[4] = kNan;
  EXPECT_REFUSED(level_through_point(*mesh, field, {0.8, 0.7, 0}), InputError, "nan at vertex 4");
}

TEST(LevelThroughPoint, does_not_depend_on_how_many_threads_look_for_it) {
  const auto soup = makers::grid(4, 4);
  const auto mesh = make_mesh(makers::copies(soup, 2000)); // 64 000 triangles, every place 2000 times
  std::vector<double> field;
  for (Index v = 0; v < mesh->vertex_count(); ++v) field.push_back(v);
  EXPECT_EQ(level_through_point(*mesh, field, {2, 3, 0}), 17); // of equally near places, the first
}

} // namespace
} // namespace dirichlet
