// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/multigrid.h"

#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <random>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "dirichlet/error.h"
#include "mesh_makers.h"
#include "parallel.h"
#include "refusal.h"

namespace dirichlet {
namespace {

std::size_t at(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

struct Problem {
  SparseMatrix K;
  Mask mask;
  Eigen::VectorXd rhs;

  /// One vertex in `sparsity`, and the first and last of all, get random values.
  explicit Problem(const SparseMatrix& matrix, unsigned sparsity = 50) : K(matrix), mask(at(K.rows())) {
    std::mt19937 random(1);
    for (auto& painted : mask) painted = random() % sparsity == 0;
    mask.front() = mask.back() = 1;
    prescribe();
  }
  Problem(const SparseMatrix& matrix, Mask painted) : K(matrix), mask(std::move(painted)) { prescribe(); }

  Multigrid::Result solve(const Multigrid& multigrid, std::vector<double>& x, double tolerance = 1e-12,
                          Index steps = 100) const {
    x.resize(mask.size());
    return multigrid.solve({rhs.data(), mask.size()}, x, tolerance, steps);
  }

  /// Largest distance from what elimination gives, over the largest number of that.
  double error(double tolerance = 1e-12) const {
    std::vector<double> x;
    solve(Multigrid(K, mask), x, tolerance);
    const Eigen::SimplicialLDLT<SymmetricMatrix, Eigen::Lower> reference(inject_symmetric(K, mask));
    const Eigen::VectorXd expected = reference.solve(rhs);
    return (Eigen::Map<Eigen::VectorXd>(x.data(), K.rows()) - expected).cwiseAbs().maxCoeff() /
           expected.cwiseAbs().maxCoeff();
  }

 private:
  void prescribe() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> value(-1, 1);
    Eigen::MatrixXd prescribed(K.rows(), 1);
    for (Eigen::Index i = 0; i < K.rows(); ++i) prescribed(i, 0) = mask[at(i)] != 0 ? value(random) : 0;
    rhs = inject_right_hand_side(K, mask, prescribed);
  }
};

SparseMatrix stiffness(const makers::PolygonSoup& soup) {
  return graph_stiffness(*makers::make_mesh(soup));
}

/// The same edges with other weights, rows that sum to 0.
template <class Weight>
SparseMatrix reweighted(SparseMatrix K, Weight weight) {
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    double sum = 0;
    for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry)
      if (entry.col() != i) {
        entry.valueRef() = -weight(std::min(i, entry.col()), std::max(i, entry.col()));
        sum -= entry.value();
      }
    K.coeffRef(i, i) = sum;
  }
  return K;
}

SparseMatrix diagonal(const std::vector<double>& values) {
  SparseMatrix K(static_cast<Index>(values.size()), static_cast<Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    K.insert(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) = values[i];
  K.makeCompressed();
  return K;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double random_number(Eigen::Index i, Eigen::Index j) { // in [0, 1), the same for an edge from both of its ends
  std::mt19937 random(static_cast<unsigned>(i * 7919 + j));
  return static_cast<double>(random()) * 0x1p-32;
}

TEST(Multigrid, agrees_with_elimination_on_all_kinds_of_surfaces) {
  EXPECT_LT(Problem(stiffness(makers::torus(90, 60))).error(), 1e-9);
  EXPECT_LT(Problem(stiffness(makers::torus(90, 60, false))).error(), 1e-9);
  EXPECT_LT(Problem(stiffness(makers::torus(2000, 4)), 1000).error(), 1e-9); // a long tube
  EXPECT_LT(Problem(stiffness(makers::sphere(20, 300))).error(), 1e-9);      // with hubs
  EXPECT_LT(Problem(stiffness(makers::klein_bottle(60, 40))).error(), 1e-9);
  EXPECT_LT(Problem(stiffness(makers::book(5, 300))).error(), 1e-9);
  EXPECT_LT(Problem(stiffness(makers::grid(100, 70)), 100'000).error(), 1e-9); // two painted vertices
}

TEST(Multigrid, agrees_with_elimination_for_weights_of_many_magnitudes) {
  const SparseMatrix K = stiffness(makers::torus(90, 60));
  EXPECT_LT(Problem(reweighted(K, [](auto i, auto j) { return std::pow(10, 6 * random_number(i, j)); })).error(1e-13),
            1e-6); // the condition takes its share
  const auto stripes = [](auto i, auto j) { return i / 90 % 8 < 4 && j / 90 % 8 < 4 ? 1e8 : 1.0; };
  EXPECT_LT(Problem(reweighted(K, stripes)).error(1e-10), 1e-6);
}

TEST(Multigrid, agrees_with_elimination_where_some_weights_are_slightly_negative) {
  const auto cotangents = [](auto i, auto j) { return random_number(i, j) - 0.03; };
  EXPECT_LT(Problem(reweighted(stiffness(makers::torus(90, 60)), cotangents)).error(), 1e-9);
}

TEST(Multigrid, takes_hardly_more_steps_on_a_mesh_of_eight_times_the_vertices) {
  const auto steps = [](Index nu, Index nv) {
    const Problem problem(stiffness(makers::torus(nu, nv)), 1000);
    std::vector<double> x;
    return problem.solve(Multigrid(problem.K, problem.mask), x, 1e-10).iterations;
  };
  const Index few = steps(200, 100), many = steps(560, 286);
  EXPECT_LE(many, 25);
  EXPECT_LE(many, few + 5);
}

TEST(Multigrid, has_nothing_to_do_when_it_starts_at_the_solution) {
  const Problem problem(stiffness(makers::torus(90, 60)));
  const Multigrid multigrid(problem.K, problem.mask);
  std::vector<double> x;
  EXPECT_GT(problem.solve(multigrid, x, 1e-10).iterations, 5);
  const auto solution = x;
  const auto again = problem.solve(multigrid, x, 1e-10);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_LE(again.relative_residual, 1e-10);
  EXPECT_TRUE(same_bits(x, solution));
}

TEST(Multigrid, gives_the_same_bits_on_one_and_two_threads_and_in_two_solves_at_once) {
  const Problem problem(stiffness(makers::torus(300, 200)));
  const auto solution = [&](unsigned threads) {
    thread_limit = threads;
    std::vector<double> x;
    problem.solve(Multigrid(problem.K, problem.mask), x);
    thread_limit = 0;
    return x;
  };
  const auto expected = solution(1);
  EXPECT_TRUE(same_bits(solution(2), expected));

  const Multigrid shared(problem.K, problem.mask);
  const auto solve = [&] {
    std::vector<double> x;
    problem.solve(shared, x);
    return x;
  };
  auto other = std::async(std::launch::async, solve);
  EXPECT_TRUE(same_bits(solve(), expected));
  EXPECT_TRUE(same_bits(other.get(), expected));
}

TEST(Multigrid, does_not_mind_the_unit_of_the_weights) {
  const Problem one(stiffness(makers::torus(40, 30)));
  for (const double unit : {0x1p+300, 0x1p-300}) {
    const Problem other(one.K * unit, one.mask);
    std::vector<double> x, y;
    const auto expected = one.solve(Multigrid(one.K, one.mask), x);
    EXPECT_EQ(other.solve(Multigrid(other.K, other.mask), y).iterations, expected.iterations);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(one.mask[i] != 0 ? x[i] : y[i], x[i]);
  }
}

TEST(Multigrid, holds_painted_values_exactly_whatever_the_start) {
  const Problem problem(stiffness(makers::torus(40, 30)));
  std::vector<double> x(problem.mask.size(), 1e3);
  problem.solve(Multigrid(problem.K, problem.mask), x);
  for (Eigen::Index i = 0; i < problem.K.rows(); ++i)
    EXPECT_TRUE(problem.mask[at(i)] == 0 || x[at(i)] == problem.rhs[i]);
}

TEST(Multigrid, solves_hundreds_of_components_and_vertices_without_neighbours) {
  const auto soup = makers::copies(makers::torus(10, 8), 400);
  Mask mask(400 * 80, 0);
  for (std::size_t piece = 0; piece < 400; ++piece) mask[piece * 80 + piece % 80] = 1;
  EXPECT_LT(Problem(stiffness(soup), mask).error(), 1e-9);

  Problem lonely(diagonal(std::vector<double>(1000, 4)), Mask(1000, 0));
  lonely.rhs.setConstant(8);
  EXPECT_LT(lonely.error(), 1e-11);
}

TEST(Multigrid, solves_the_smallest_systems) {
  const SparseMatrix nothing(0, 0);
  std::vector<double> x;
  EXPECT_EQ(Multigrid(nothing, {}).solve({}, x, 1e-10, 1).iterations, 0);

  const SparseMatrix one = diagonal({4});
  const std::vector<double> b{2};
  x = {0};
  Multigrid(one, {0}).solve(b, x, 1e-15, 2);
  EXPECT_DOUBLE_EQ(x[0], 0.5);
  EXPECT_EQ(Multigrid(one, {1}).solve(b, x, 1e-15, 1).iterations, 0);
  EXPECT_EQ(x[0], 2);

  const SparseMatrix K = stiffness(makers::tetrahedron());
  EXPECT_LT(Problem(K, {1, 0, 0, 0}).error(), 1e-12);
  EXPECT_LT(Problem(K, {1, 0, 1, 1}).error(), 1e-12);
  EXPECT_EQ(Problem(K, {1, 1, 1, 1}).error(), 0);
}

TEST(Multigrid, answers_zero_to_zero) {
  const SparseMatrix K = stiffness(makers::torus(40, 30));
  Mask mask(1200, 0);
  mask[7] = 1;
  const std::vector<double> b(1200, 0.0);
  std::vector<double> x(1200, 3.0);
  EXPECT_EQ(Multigrid(K, mask).solve(b, x, 1e-10, 100).relative_residual, 0);
  EXPECT_EQ(x, b);
}

TEST(Multigrid, stays_small_beside_a_hub_of_thousands_of_neighbours) {
  Mask mask(5 * 6000 + 2, 0); // both poles are free
  for (std::size_t v = 2; v < mask.size(); v += 1000) mask[v] = 1;
  const Problem problem(stiffness(makers::sphere(5, 6000)), mask);
  const Multigrid multigrid(problem.K, problem.mask);
  EXPECT_LT(multigrid.bytes(), 150 * problem.K.rows());
  std::vector<double> x;
  EXPECT_LE(problem.solve(multigrid, x, 1e-10).iterations, 30);
}

TEST(Multigrid, says_which_residual_it_reached_when_steps_run_out_and_leaves_the_start_alone) {
  const Problem problem(stiffness(makers::torus(90, 60)));
  const Multigrid multigrid(problem.K, problem.mask);
  std::vector<double> x(problem.mask.size(), 5.0);
  EXPECT_REFUSED(problem.solve(multigrid, x, 1e-10, 2), SolverError, "after 2 steps", "residual of", "1e-10");
  EXPECT_EQ(x, std::vector<double>(x.size(), 5.0));
}

TEST(Multigrid, gives_up_soon_where_rounding_allows_no_smaller_residual) {
  const Problem problem(stiffness(makers::torus(40, 30)));
  std::vector<double> x;
  try {
    problem.solve(Multigrid(problem.K, problem.mask), x, 1e-18, 5000);
    FAIL() << "a residual below the rounding of its own terms";
  } catch (const SolverError& error) {
    EXPECT_EQ(std::string(error.what()).find("after 5000"), std::string::npos) << error.what();
  }
}

TEST(Multigrid, refuses_a_matrix_that_is_not_positive_definite) {
  EXPECT_REFUSED(Multigrid(diagonal({1, 1, 0, 1}), Mask(4, 0)), SolverError, "not positive definite", "row 2");
  EXPECT_REFUSED(Multigrid(diagonal({-1, 1}), Mask(2, 0)), SolverError, "not positive definite", "row 0");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(Multigrid(diagonal({1, nan}), Mask(2, 0)), SolverError, "row 1");

  Problem shifted(stiffness(makers::torus(90, 60)), 1000); // waves longer than those of the shift have negative energy
  for (Eigen::Index i = 0; i < shifted.K.rows(); ++i) shifted.K.coeffRef(i, i) -= 0.3;
  std::vector<double> x;
  EXPECT_REFUSED(shifted.solve(Multigrid(shifted.K, shifted.mask), x), SolverError, "not positive definite",
                 "coarsest");

  Problem repelling(stiffness(makers::torus(20, 20)));
  for (Eigen::Index i = 0; i < repelling.K.rows(); ++i) repelling.K.coeffRef(i, i) = 1;
  repelling.K = repelling.K.cwiseAbs();
  EXPECT_REFUSED(repelling.solve(Multigrid(repelling.K, repelling.mask), x), SolverError, "not positive definite");
}

TEST(Multigrid, refuses_numbers_that_are_not_finite_and_arrays_that_do_not_fit) {
  Problem problem(stiffness(makers::torus(20, 20)));
  const Multigrid multigrid(problem.K, problem.mask);
  std::vector<double> x(400), shorter(399);
  EXPECT_REFUSED(multigrid.solve({problem.rhs.data(), 400}, shorter, 1e-10, 9), InputError, "399", "400");
  EXPECT_REFUSED(Multigrid(problem.K, Mask(3, 0)), InputError, "mask of 3");
  problem.rhs[5] = std::numeric_limits<double>::infinity();
  EXPECT_REFUSED(problem.solve(multigrid, x), SolverError, "not finite");
  problem.rhs[5] = 0;
  x[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(problem.solve(multigrid, x), SolverError, "not finite");
}

} // namespace
} // namespace dirichlet
