// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_weights.h"

#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "parallel.h"

namespace dirichlet {
namespace {

struct WeightedEdges {
  std::vector<Index> edges;
  std::vector<double> weights;
};

/// With self-loops, edges that come several times in both directions, weights 0, a hub, and a vertex without an edge.
WeightedEdges random_edges(Index n, Index count) {
  std::mt19937 random(1);
  WeightedEdges all;
  for (Index e = 0; e < count; ++e) {
    const auto any = [&] { return static_cast<Index>(random() % static_cast<unsigned>(n - 1)); };
    all.edges.insert(all.edges.end(), {e % 3 == 0 ? 0 : any(), any()});
    all.weights.push_back(e % 7 == 0 ? 0.0 : std::uniform_real_distribution<>(0, 1)(random));
  }
  return all;
}

Eigen::MatrixXd dense_stiffness(Index n, const WeightedEdges& all) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t e = 0; e < all.weights.size(); ++e) {
    const Index i = all.edges[2 * e], j = all.edges[2 * e + 1];
    if (i == j) continue;
    K(i, j) -= all.weights[e];
    K(j, i) -= all.weights[e];
    K(i, i) += all.weights[e];
    K(j, j) += all.weights[e];
  }
  return K;
}

TEST(StiffnessOfEdges, adds_the_weights_of_every_edge_and_leaves_out_self_loops) {
  EXPECT_EQ(stiffness_of_edges(0, {}, {}).nonZeros(), 0);
  for (const Index count : {0, 1, 40, 400}) {
    const WeightedEdges all = random_edges(30, count);
    const Eigen::MatrixXd K = stiffness_of_edges(30, all.edges, all.weights);
    EXPECT_LE((K - dense_stiffness(30, all)).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_EQ(K, K.transpose());
  }
}

TEST(StiffnessOfEdges, columns_ascend_and_zeros_and_every_diagonal_are_stored) {
  const std::vector<Index> edges{3, 1, 1, 0, 2, 2};
  const SparseMatrix K = stiffness_of_edges(5, edges, std::vector<double>{0, 2, 7});
  const std::vector<Index> columns(K.innerIndexPtr(), K.innerIndexPtr() + K.nonZeros());
  EXPECT_EQ(columns, (std::vector<Index>{0, 1, 0, 1, 3, 2, 1, 3, 4}));
  const std::vector<double> values(K.valuePtr(), K.valuePtr() + K.nonZeros());
  EXPECT_EQ(values, (std::vector<double>{2, -2, -2, 2, 0, 0, 0, 0, 0}));
}

TEST(StiffnessOfEdges, is_the_same_whatever_the_thread_count) {
  constexpr Index n = 50'000;
  const WeightedEdges all = random_edges(n, 4 * n);
  const SparseMatrix K = stiffness_of_edges(n, all.edges, all.weights);
  thread_limit = 1;
  const SparseMatrix serial = stiffness_of_edges(n, all.edges, all.weights);
  thread_limit = 3;
  const SparseMatrix thirds = stiffness_of_edges(n, all.edges, all.weights);
  thread_limit = 0;
  for (const SparseMatrix& other : {serial, thirds}) {
    ASSERT_EQ(other.nonZeros(), K.nonZeros());
    EXPECT_TRUE(std::equal(K.valuePtr(), K.valuePtr() + K.nonZeros(), other.valuePtr()));
    EXPECT_TRUE(std::equal(K.innerIndexPtr(), K.innerIndexPtr() + K.nonZeros(), other.innerIndexPtr()));
  }
}

} // namespace
} // namespace dirichlet
