// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elimination_tree.h"

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

TEST(EliminationTree, knows_the_parent_and_the_entries_of_every_column_of_the_factor) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const auto n = static_cast<Index>(1 + random() % 40);
    const Rows pattern = random_pattern(n, static_cast<Index>(random() % 80), random), factor = filled(pattern);
    const EliminationTree tree = eliminate(compressed(pattern));
    for (Index j = 0; j < n; ++j) {
      Index count = 0, first = -1;
      for (Index i = j; i < n; ++i) {
        count += factor[at(i)][at(j)] ? 1 : 0;
        if (i > j && first == -1 && factor[at(i)][at(j)]) first = i;
      }
      const Index k = tree.rank[at(j)];
      EXPECT_EQ(tree.count[at(k)], count) << "trial " << trial << ", column " << j;
      EXPECT_EQ(tree.parent[at(k)], first == -1 ? -1 : tree.rank[at(first)]) << "trial " << trial << ", column " << j;
    }
  }
}

TEST(EliminationTree, numbers_every_subtree_as_one_run_that_ends_with_its_root) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const EliminationTree tree = eliminate(compressed(random_pattern(50, 60, random)));
    std::vector<Index> first(50);
    for (Index k = 0; k < 50; ++k) first[at(k)] = k;
    for (Index k = 0, before = 0; k < 50; ++k) {
      const Index up = tree.parent[at(k)];
      EXPECT_TRUE(up == -1 || up > k);
      if (up != -1) first[at(up)] = std::min(first[at(up)], first[at(k)]);
      if (up == -1) {
        EXPECT_EQ(first[at(k)], before) << "a root's subtree begins where the one before ends";
        before = k + 1;
      }
    }
    std::vector<Index> size(50, 1);
    for (Index k = 0; k < 50; ++k) {
      EXPECT_EQ(first[at(k)], k - size[at(k)] + 1) << k;
      if (tree.parent[at(k)] != -1) size[at(tree.parent[at(k)])] += size[at(k)];
    }
  }
}

} // namespace
} // namespace dirichlet
