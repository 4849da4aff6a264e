// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_tree.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace dirichlet {
namespace {

std::vector<Point2> scattered(std::size_t count, std::mt19937& random) {
  std::uniform_int_distribution<int> place(0, 40); // so that some share a place, a row or a column
  std::vector<Point2> points(count);
  for (Point2& p : points) p = {place(random) / 8.0, place(random) / 8.0};
  return points;
}

bool is_left(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) >= 0;
}

TEST(CornerTree, finds_every_marked_point_in_a_triangle) {
  std::mt19937 random(3);
  CornerTree tree;
  for (const std::size_t count : {1, 16, 17, 100, 1000}) {
    const auto points = scattered(count, random);
    tree.build(points);
    std::vector<bool> marked(count, false);
    std::size_t found = 0;
    for (int round = 0; round < 200; ++round) {
      const auto changed = static_cast<std::size_t>(random() % count);
      marked[changed] = round % 4 != 0;
      tree.mark(static_cast<Index>(changed), marked[changed]);
      std::array<Point2, 3> t{points[random() % count], points[random() % count], {2.5, 2.5}};
      if (!is_left(t[0], t[1], t[2])) std::swap(t[0], t[1]);
      std::set<Index> met;
      EXPECT_FALSE(tree.any_in(t, 0, [&](Index i) {
        met.insert(i);
        return false;
      }));
      for (std::size_t i = 0; i < count; ++i) {
        const Point2 p = points[i];
        const bool inside = is_left(t[0], t[1], p) && is_left(t[1], t[2], p) && is_left(t[2], t[0], p);
        EXPECT_EQ(tree.is_marked(static_cast<Index>(i)), marked[i]);
        EXPECT_TRUE(marked[i] || !met.contains(static_cast<Index>(i)));
        EXPECT_TRUE(!marked[i] || !inside || met.contains(static_cast<Index>(i)));
        if (marked[i] && inside) ++found;
      }
    }
    EXPECT_GT(found, 0U);
  }
}

TEST(CornerTree, looks_at_few_of_many_points) {
  std::vector<Point2> points;
  for (int i = 0; i < 10'000; ++i) points.push_back({i / 10'000.0, i % 2 == 0 ? 0.0 : 1.0});
  CornerTree tree;
  tree.build(points);
  for (Index i = 0; i < 10'000; ++i) tree.mark(i, true);
  int looks = 0;
  EXPECT_FALSE(tree.any_in({Point2{0.5, 0}, Point2{0.5001, 0}, Point2{0.5, 1}}, 0, [&](Index) {
    ++looks;
    return false;
  }));
  EXPECT_GT(looks, 0);
  EXPECT_LT(looks, 200);
}

} // namespace
} // namespace dirichlet
