// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elimination_forest.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "index.h"

namespace dirichlet {
namespace {

using Rows = std::vector<std::vector<bool>>;

Rows random_pattern(Index n, Index entries, std::mt19937& random) {
  Rows entry(at(n), std::vector<bool>(at(n), false));
  for (std::size_t i = 0; i < at(n); ++i) entry[i][i] = true;
  for (Index e = 0; e < entries; ++e) {
    const auto i = random() % static_cast<unsigned>(n), j = random() % static_cast<unsigned>(n);
    entry[i][j] = entry[j][i] = true;
  }
  return entry;
}

OrderedPattern compressed(const Rows& entry) {
  OrderedPattern pattern{{0}, {}, {}};
  for (std::size_t i = 0; i < entry.size(); ++i) {
    for (std::size_t j = 0; j < entry.size(); ++j) {
      if (j == i) pattern.upper.push_back(static_cast<Index>(pattern.columns.size()));
      if (entry[i][j]) pattern.columns.push_back(static_cast<Index>(j));
    }
    pattern.offsets.push_back(static_cast<Index>(pattern.columns.size()));
  }
  return pattern;
}

/// One column after the other: the neighbours of what is eliminated become neighbours.
Rows filled(Rows entry) {
  for (std::size_t j = 0; j < entry.size(); ++j)
    for (std::size_t a = j + 1; a < entry.size(); ++a)
      for (std::size_t b = j + 1; b < entry.size() && entry[a][j]; ++b)
        if (entry[b][j]) entry[a][b] = true;
  return entry;
}

TEST(EliminationForest, has_exactly_the_rows_of_every_column_of_the_factor) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto n = static_cast<Index>(1 + random() % 40);
    const Rows pattern = random_pattern(n, static_cast<Index>(random() % 80), random), factor = filled(pattern);
    const EliminationForest forest = eliminate(compressed(pattern));
    for (Index j = 0; j < n; ++j) {
      const Index s = forest.owner[at(j)];
      std::vector<Index> rows(forest.rows_of(s).begin(), forest.rows_of(s).end()), expected;
      for (Index i = n; i-- > j + 1;)
        if (forest.owner[at(i)] == s) rows.insert(rows.begin(), i);
      for (Index i = j + 1; i < n; ++i)
        if (factor[at(i)][at(j)]) expected.push_back(i);
      EXPECT_EQ(rows, expected) << "trial " << trial << ", column " << j;
    }
  }
}

TEST(EliminationForest, numbers_every_subtree_as_one_run_that_ends_with_its_root) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const EliminationForest forest = eliminate(compressed(random_pattern(50, 60, random)));
    std::vector<Index> first(at(forest.size())), size(at(forest.size()), 1);
    for (Index s = 0; s < forest.size(); ++s) first[at(s)] = s;
    for (Index s = 0, begin = 0; s < forest.size(); ++s) {
      const auto rows = forest.rows_of(s);
      const Index up = forest.parent[at(s)];
      EXPECT_EQ(up, rows.empty() ? -1 : forest.owner[at(rows.front())]);
      EXPECT_EQ(first[at(s)], s - size[at(s)] + 1) << s;
      if (up == -1) {
        EXPECT_EQ(first[at(s)], begin) << "a root's subtree begins where the one before ends";
        begin = s + 1;
        continue;
      }
      ASSERT_GT(up, s);
      first[at(up)] = std::min(first[at(up)], first[at(s)]);
      size[at(up)] += size[at(s)];
    }
  }
}

} // namespace
} // namespace dirichlet
