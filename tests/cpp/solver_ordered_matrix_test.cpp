// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/ordered_matrix.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "mesh_makers.h"

namespace dirichlet {
namespace {

std::vector<Index> shuffled(Index n) {
  std::vector<Index> order(at(n));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  return order;
}

/// Every entry of K in its new place once, and where `upper` says those from the diagonal on.
void expect_reordered(const SparseMatrix& K, const OrderedMatrix& ordered, const std::vector<Index>& order) {
  ASSERT_EQ(ordered.size(), K.rows());
  ASSERT_EQ(ordered.offsets.back(), K.nonZeros());
  for (Index i = 0; i < ordered.size(); ++i) {
    const auto row = ordered.columns.begin() + ordered.offsets[at(i)];
    const std::set<Index> columns(row, ordered.columns.begin() + ordered.offsets[at(i) + 1]);
    EXPECT_EQ(static_cast<Index>(columns.size()), ordered.offsets[at(i) + 1] - ordered.offsets[at(i)]) << i;
    for (Index e = ordered.offsets[at(i)]; e < ordered.offsets[at(i) + 1]; ++e) {
      const Index j = ordered.columns[at(e)];
      EXPECT_EQ(ordered.values[at(e)], K.coeff(order[at(i)], order[at(j)])) << i << ' ' << j;
      EXPECT_EQ(j >= i, e >= ordered.upper[at(i)]) << i << ' ' << j;
    }
  }
}

TEST(OrderedMatrix, is_the_matrix_renumbered) {
  SparseMatrix K = graph_stiffness(*makers::make_mesh(makers::torus(150, 130))); // large enough for two threads
  for (Index e = 0; e < K.nonZeros(); ++e) K.valuePtr()[e] = e;                  // no two alike
  const std::vector<Index> order = shuffled(static_cast<Index>(K.rows()));
  expect_reordered(K, order_matrix(K, order), order);
}

TEST(OrderedMatrix, has_rows_of_any_length) {
  constexpr Index kSize = 500;
  std::vector<Eigen::Triplet<double, Index>> star; // row 0 is full; row 7 empty but for it
  for (Index i = 0; i < kSize; ++i) {
    star.emplace_back(0, i, 1.0 + i);
    if (i > 0) star.emplace_back(i, 0, 1.0 + i);
    if (i > 7) star.emplace_back(i, i, -1.0 - i);
  }
  SparseMatrix K(kSize, kSize);
  K.setFromTriplets(star.begin(), star.end());
  const std::vector<Index> order = shuffled(kSize);
  expect_reordered(K, order_matrix(K, order), order);
}

TEST(OrderedMatrix, of_nothing_is_empty) {
  const OrderedMatrix ordered = order_matrix(SparseMatrix(0, 0), {});
  EXPECT_EQ(ordered.size(), 0);
  EXPECT_EQ(ordered.offsets, std::vector<Index>{0});
}

} // namespace
} // namespace dirichlet
