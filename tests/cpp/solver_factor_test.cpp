// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/factor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "mesh_makers.h"
#include "parallel.h"
#include "refusal.h"
#include "solver/ordering.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

Graph graph_of(const SparseMatrix& K) {
  return {{K.outerIndexPtr(), at(static_cast<Index>(K.rows())) + 1},
          {K.innerIndexPtr(), static_cast<std::size_t>(K.nonZeros())}};
}

/// A symmetric matrix with a dominant diagonal: `entries` random couplings among n rows.
SparseMatrix random_matrix(Index n, Index entries, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Eigen::Triplet<double, Index>> triplets;
  std::vector<double> diagonal(at(n), 0.5);
  for (Index e = 0; e < entries && n > 1; ++e) {
    const auto i = static_cast<Index>(random() % static_cast<unsigned>(n));
    const auto j = static_cast<Index>(random() % static_cast<unsigned>(n));
    if (i == j) continue;
    const double weight = std::uniform_real_distribution<double>(-1, 1)(random);
    triplets.emplace_back(i, j, weight);
    triplets.emplace_back(j, i, weight);
    diagonal[at(i)] += std::abs(weight);
    diagonal[at(j)] += std::abs(weight);
  }
  for (Index i = 0; i < n; ++i) triplets.emplace_back(i, i, diagonal[at(i)]);
  SparseMatrix K(n, n);
  K.setFromTriplets(triplets.begin(), triplets.end());
  return K;
}

/// A factor and all that goes into it; paint and right-hand sides are by vertex.
template <class Real = double>
struct Problem {
  SparseMatrix K;
  std::shared_ptr<const SymbolicFactor> symbolic;
  std::vector<Index> position; // of every vertex in the order
  Factor<Real> factor;
  Mask painted;

  explicit Problem(const SparseMatrix& matrix, std::int64_t most_kept = std::int64_t{1} << 40,
                   Pivots pivots = Pivots::subtracted)
      : K(matrix), symbolic(std::make_shared<const SymbolicFactor>(
                       analyse(graph_of(K), fill_reducing_order(graph_of(K).offsets, graph_of(K).neighbours)))),
        position(inverse_permutation(symbolic->order)),
        factor(symbolic, std::make_shared<const OrderedMatrix>(order_matrix(K, symbolic->order)), pivots, most_kept),
        painted(at(symbolic->size()), 0) {}

  Mask fixed() const {
    Mask mask(painted.size());
    for (std::size_t v = 0; v < painted.size(); ++v) mask[at(position[v])] = painted[v];
    return mask;
  }

  std::vector<Real> solve(const Eigen::MatrixXd& rhs) const {
    const auto k = static_cast<Index>(rhs.cols());
    std::vector<Real> x(painted.size() * at(k));
    for (Index i = 0; i < rhs.rows(); ++i)
      for (Index c = 0; c < k; ++c) x[at(position[at(i)] * k + c)] = static_cast<Real>(rhs(i, c));
    factor.solve(x, k);
    return x;
  }

  double error(const Eigen::MatrixXd& rhs) const {
    const Eigen::MatrixXd A = Eigen::MatrixXd(inject_symmetric(K, painted)).selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd expected = A.llt().solve(rhs);
    const auto x = solve(rhs);
    double worst = 0;
    for (Index i = 0; i < rhs.rows(); ++i)
      for (Index c = 0; c < rhs.cols(); ++c)
        worst = std::max(
            worst, std::abs(expected(i, c) -
                            static_cast<double>(x[at(position[at(i)]) * at(static_cast<Index>(rhs.cols())) + at(c)])));
    return worst / std::max(1.0, expected.size() ? expected.cwiseAbs().maxCoeff() : 0.0);
  }

  /// Turns paint on or off, and tells the factor.
  double stroke(const std::vector<Index>& vertices) {
    std::vector<Index> changed;
    for (const Index v : vertices) {
      painted[at(v)] ^= 1;
      changed.push_back(position[at(v)]);
      for (SparseMatrix::InnerIterator entry(K, v); entry; ++entry)
        changed.push_back(position[at(static_cast<Index>(entry.col()))]);
    }
    return factor.refactor(fixed(), changed);
  }
};

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

SparseMatrix shifted(SparseMatrix K, double shift) {
  for (Index i = 0; i < K.rows(); ++i) K.coeffRef(i, i) += shift;
  return K;
}

TEST(Symbolic, holds_every_entry_of_the_factor_and_numbers_children_before_parents) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const SparseMatrix K = random_matrix(60, 90, seed);
    std::vector<Index> order(60);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    const SymbolicFactor factor = analyse(graph_of(K), order);
    const std::vector<Index> position = inverse_permutation(factor.order);
    std::vector<std::vector<bool>> entry(60, std::vector<bool>(60, false)); // elimination, one column after the other
    for (Index i = 0; i < 60; ++i)
      for (SparseMatrix::InnerIterator e(K, i); e; ++e)
        entry[at(position[at(static_cast<Index>(e.col()))])][at(position[at(i)])] = true;
    for (std::size_t j = 0; j < 60; ++j)
      for (std::size_t a = j + 1; a < 60; ++a)
        for (std::size_t b = j + 1; b < 60 && entry[a][j]; ++b)
          if (entry[b][j]) entry[a][b] = true;
    for (Index s = 0; s < factor.supernode_count(); ++s) {
      const auto rows = factor.rows_of(s);
      EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
      EXPECT_TRUE(factor.parent[at(s)] == -1 || factor.parent[at(s)] > s);
      EXPECT_EQ(rows.empty() ? -1 : factor.owner[at(rows.front())], factor.parent[at(s)]);
      for (Index j = factor.columns[at(s)]; j < factor.columns[at(s) + 1]; ++j)
        for (Index i = factor.columns[at(s) + 1]; i < 60; ++i)
          EXPECT_TRUE(!entry[at(i)][at(j)] || std::binary_search(rows.begin(), rows.end(), i)) << i << ' ' << j;
    }
  }
}

TEST(Symbolic, halves_do_not_touch_each_other) {
  const auto mesh = make_mesh(makers::torus(60, 40));
  const SparseMatrix K = graph_stiffness(*mesh);
  const SymbolicFactor factor = analyse(graph_of(K), fill_reducing_order(graph_of(K).offsets, graph_of(K).neighbours));
  ASSERT_GT(factor.group[1], 0);
  ASSERT_GT(factor.group[2], factor.group[1]);
  const Index shared = factor.columns[at(factor.group[2])];
  for (Index s = 0; s < factor.group[1]; ++s)
    for (const Index row : factor.rows_of(s)) EXPECT_TRUE(row < factor.columns[at(factor.group[1])] || row >= shared);
}

TEST(Factor, solves_random_systems_like_a_dense_solver) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Problem<> problem(random_matrix(static_cast<Index>(random() % 120), static_cast<Index>(random() % 400), seed));
    for (auto& flag : problem.painted) flag = random() % 4 == 0;
    problem.factor.factor(problem.fixed());
    EXPECT_LE(problem.error(Eigen::MatrixXd::Random(problem.K.rows(), 1)), 1e-13);
    EXPECT_LE(problem.error(Eigen::MatrixXd::Random(problem.K.rows(), 5)), 1e-13);
  }
}

TEST(Factor, solves_meshes_with_thousands_of_vertices) {
  for (const auto& soup : {makers::torus(70, 50), makers::sphere(40, 70), makers::grid(80, 45, false)}) {
    Problem<> problem(graph_stiffness(*make_mesh(soup)));
    for (std::size_t v = 0; v < problem.painted.size(); v += 97) problem.painted[v] = 1;
    problem.factor.factor(problem.fixed());
    EXPECT_LE(problem.error(Eigen::MatrixXd::Random(problem.K.rows(), 3)), 1e-11);
  }
}

TEST(Factor, solves_for_right_hand_sides_that_are_mostly_zero) {
  Problem<> problem(shifted(graph_stiffness(*make_mesh(makers::torus(40, 30))), 1e-3));
  problem.factor.factor(problem.fixed());
  for (const Index k : {1, 3}) {
    Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(1200, k);
    for (Index i = 0; i < 1200; i += 131) rhs(i, i % k) = 1; // what passes them by is 0, what is above them is not
    EXPECT_LE(problem.error(rhs), 1e-12);
  }
}

TEST(Factor, nothing_one_vertex_and_two_are_systems_too) {
  for (const Index n : {0, 1, 2}) {
    Problem<> problem(random_matrix(n, 3, 1));
    problem.factor.factor(problem.fixed());
    EXPECT_LE(problem.error(Eigen::MatrixXd::Ones(n, 2)), 1e-15);
  }
}

TEST(Factor, everything_painted_is_the_identity) {
  Problem<> problem(graph_stiffness(*make_mesh(makers::torus(20, 20))));
  std::fill(problem.painted.begin(), problem.painted.end(), 1);
  problem.factor.factor(problem.fixed());
  EXPECT_EQ(problem.error(Eigen::MatrixXd::Random(400, 1)), 0);
}

TEST(Factor, after_any_strokes_equals_a_whole_factorisation_bit_for_bit) {
  const Eigen::MatrixXd rhs = Eigen::MatrixXd::Random(90 * 70, 1);
  const SparseMatrix K = shifted(graph_stiffness(*make_mesh(makers::torus(90, 70))), 1e-3);
  for (const std::int64_t budget : {std::int64_t{0}, std::int64_t{1} << 20, std::int64_t{1} << 40}) {
    Problem<> partial(K, budget), whole(K, budget);
    std::mt19937 random(5);
    partial.factor.factor(partial.fixed());
    for (int stroke = 0; stroke < 12; ++stroke) {
      std::vector<Index> vertices;
      const auto start = random() % 6300, size = 1 + random() % 200;
      for (std::size_t i = 0; i < size; ++i) vertices.push_back(static_cast<Index>((start + i) % 6300));
      const double share = partial.stroke(vertices);
      EXPECT_GT(share, 0);
      EXPECT_LE(share, 1);
      whole.painted = partial.painted;
      whole.factor.factor(whole.fixed());
      EXPECT_TRUE(same_bits(partial.solve(rhs), whole.solve(rhs))) << "stroke " << stroke << ", budget " << budget;
    }
  }
}

TEST(Factor, a_small_stroke_repeats_little_of_the_work) {
  Problem<> problem(shifted(graph_stiffness(*make_mesh(makers::torus(800, 12))), 1e-3)); // a long tube
  problem.factor.factor(problem.fixed());
  EXPECT_LT(problem.stroke({0, 1, 2}), 0.2);
}

TEST(Factor, no_stroke_changes_nothing) {
  Problem<> problem(shifted(graph_stiffness(*make_mesh(makers::torus(30, 30))), 1e-3));
  problem.factor.factor(problem.fixed());
  EXPECT_EQ(problem.stroke({}), 0);
}

TEST(Factor, is_the_same_on_one_thread_and_on_two) {
  const Eigen::MatrixXd rhs = Eigen::MatrixXd::Random(300 * 200, 4);
  Problem<> problem(shifted(graph_stiffness(*make_mesh(makers::torus(300, 200))), 1e-3));
  problem.factor.factor(problem.fixed());
  const auto together = problem.solve(rhs);
  thread_limit = 1;
  problem.factor.factor(problem.fixed());
  const auto alone = problem.solve(rhs);
  thread_limit = 0;
  EXPECT_TRUE(same_bits(together, alone));
}

TEST(Factor, in_single_precision_is_right_to_single_precision) {
  Problem<float> problem(graph_stiffness(*make_mesh(makers::torus(60, 40))));
  for (std::size_t v = 0; v < problem.painted.size(); v += 31) problem.painted[v] = 1;
  problem.factor.factor(problem.fixed());
  const double error = problem.error(Eigen::MatrixXd::Random(2400, 2));
  EXPECT_LE(error, 1e-4);
  EXPECT_GT(error, 1e-12);
}

TEST(FactorRefuses, a_singular_matrix_naming_the_vertex_and_serves_the_next_painting) {
  makers::PolygonSoup soup = makers::torus(12, 12);
  soup.positions.insert(soup.positions.end(), 3, 0.0); // vertex 144, isolated: a row of zeros
  Problem<> problem(graph_stiffness(*make_mesh(soup)));
  problem.painted[7] = 1;
  EXPECT_REFUSED(problem.factor.factor(problem.fixed()), SolverError, "singular at vertex 144", "thin faces",
                 "Laplacian, mend it");
  problem.painted[144] = 1;
  problem.factor.factor(problem.fixed());
  EXPECT_LE(problem.error(Eigen::MatrixXd::Random(145, 1)), 1e-12);
}

/// Beside a weight of 1e9, single precision does not see that of 1 by which two vertices hang on the painted one.
TEST(FactorRefuses, a_matrix_that_is_singular_to_single_precision_saying_what_helps) {
  SparseMatrix K(3, 3);
  const std::vector<Eigen::Triplet<double>> entries{{0, 0, 1e9}, {0, 1, -1e9}, {1, 0, -1e9}, {1, 1, 1e9 + 1},
                                                    {1, 2, -1},  {2, 1, -1},   {2, 2, 1}};
  K.setFromTriplets(entries.begin(), entries.end());
  Problem<float> single(K);
  single.painted[2] = 1;
  EXPECT_REFUSED(single.factor.factor(single.fixed()), SolverError, "singular to single precision at vertex ",
                 "thin faces", "a float64 factor");
  Problem<> twice(K);
  twice.painted[2] = 1;
  twice.factor.factor(twice.fixed());
  EXPECT_LE(twice.error(Eigen::MatrixXd::Random(3, 1)), 1e-6);
}

/// The Laplacian of a grid's edges whose weights are anything between 1e-12 and 1e12.
SparseMatrix uneven_laplacian(Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<> exponent(-12, 12);
  SparseMatrix K = graph_stiffness(*make_mesh(makers::grid(n, n)));
  for (Index i = 0; i < K.rows(); ++i)
    for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry)
      if (entry.col() < i)
        entry.valueRef() = K.coeffRef(static_cast<Index>(entry.col()), i) = -std::pow(10.0, exponent(random));
  for (Index i = 0; i < K.rows(); ++i) {
    double sum = 0;
    for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry) sum += entry.col() == i ? 0 : entry.value();
    K.coeffRef(i, i) = -sum;
  }
  return K;
}

TEST(Factor, of_summed_pivots_gives_1_everywhere_where_1_is_painted_however_uneven_the_weights) {
  for (const Index n : {3, 20, 120}) { // of fronts of any width
    Problem<> problem(uneven_laplacian(n, 7), std::int64_t{1} << 40, Pivots::summed);
    for (const Index v : {1, 5, n * n / 2}) problem.painted[at(v)] = 1;
    problem.factor.factor(problem.fixed());
    Eigen::MatrixXd right(problem.K.rows(), 1);
    for (Index i = 0; i < problem.K.rows(); ++i) {
      right(i, 0) = problem.painted[at(i)];
      for (SparseMatrix::InnerIterator entry(problem.K, i); entry; ++entry)
        if (problem.painted[at(i)] == 0 && problem.painted[at(static_cast<Index>(entry.col()))] != 0)
          right(i, 0) -= entry.value();
    }
    for (const double x : problem.solve(right)) ASSERT_NEAR(x, 1, 1e-12) << n;
  }
}

TEST(Factor, of_summed_pivots_is_the_same_after_strokes_and_by_any_number_of_threads) {
  const SparseMatrix K = uneven_laplacian(120, 3);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(K.rows(), 1);
  Problem<> strokes(K, std::int64_t{1} << 40, Pivots::summed), whole(K, 0, Pivots::summed);
  strokes.painted[5] = 1;
  strokes.factor.factor(strokes.fixed());
  for (const Index v : {900, 901, 5000, 900}) strokes.stroke({v});
  whole.painted = strokes.painted;
  thread_limit = 1;
  whole.factor.factor(whole.fixed());
  thread_limit = 0;
  EXPECT_TRUE(same_bits(strokes.solve(right), whole.solve(right)));
}

} // namespace
} // namespace dirichlet
