// SPDX-License-Identifier: GPL-3.0-or-later
#include "twin.h"

#include <gtest/gtest.h>

#include "dirichlet/field.h"
#include "index.h"
#include "mesh_makers.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

/// A square of n × n cells in the plane, its two columns at the ends painted 0 and 1; y is a millionth of what it was.
struct Squashed {
  static constexpr Index n = 30;
  std::unique_ptr<Mesh> mesh;
  std::vector<Index> painted;
  Eigen::VectorXd along = Eigen::VectorXd((n + 1) * (n + 1)); ///< x: the field
  Squashed() {
    makers::PolygonSoup soup = makers::grid(n, n);
    for (Index v = 0; v < along.size(); ++v) {
      soup.positions[3 * at(v) + 1] *= 1e-6;
      soup.positions[3 * at(v) + 2] = 0;
      along[v] = soup.positions[3 * at(v)] / n;
      if (along[v] == 0 || along[v] == 1) painted.push_back(v);
    }
    mesh = make_mesh(soup);
  }
  [[nodiscard]] Field solve(const SolverOptions& options) const {
    return HarmonicSolver(*mesh, painted, options, Laplacian::cotangent).solve(along(painted));
  }
};

TEST(RelativeResidual, of_an_exact_field_is_small_however_much_larger_some_weights_are_than_others) {
  const Squashed problem;
  const Field field = problem.solve({});
  ASSERT_LE((field.values.col(0) - problem.along).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LE(field.report.relative_residual, 1e-12);
  EXPECT_TRUE(field.report.warnings.empty()) << field.report.warnings.front();
}

TEST(RelativeResidual, of_what_an_iteration_leaves_there_is_as_large_as_its_error_and_said) {
  const Squashed problem;
  SolverOptions options;
  options.method = Method::multigrid;
  const Field field = problem.solve(options);
  const double error = (field.values.col(0) - problem.along).cwiseAbs().maxCoeff();
  ASSERT_GT(error, 1e-7); // else there is nothing to say
  EXPECT_GE(field.report.relative_residual, error / 100);
  ASSERT_FALSE(field.report.warnings.empty());
  EXPECT_NE(field.report.warnings.back().find("holds to its equations only"), std::string::npos);
}

/// The weights of y are 1e12 times those of x: what is off by a column of one x changes only the small ones.
TEST(RelativeResidual, sees_what_the_least_weights_see_whatever_the_diagonal_has_lost) {
  const Squashed problem;
  Stiffness stiffness = make_stiffness(*problem.mesh, Laplacian::cotangent);
  Mask mask(at(problem.mesh->vertex_count()), 0);
  Block prescribed = Block::Zero(problem.along.size(), 2);
  for (const Index v : problem.painted) {
    mask[at(v)] = 1;
    prescribed.row(v).setConstant(problem.along[v]);
  }
  const Block rhs = inject_right_hand_side(stiffness.K, mask, prescribed);
  Block x(problem.along.size(), 2);
  x.col(0) = x.col(1) = problem.along;
  for (Index v = 0; v < x.rows(); ++v)
    if (mask[at(v)] == 0) x(v, 1) += 1e-3 * problem.along[v] * (1 - problem.along[v]); // not the field, but smooth
  const auto residual = [&](Index column, double error) {
    return relative_residual(stiffness.K, mask, rhs.col(column), x.col(column), Eigen::ArrayXd::Constant(1, error));
  };
  constexpr double kRounding = 1e-15;
  EXPECT_LE(residual(0, kRounding), 1e-12);
  EXPECT_GE(residual(1, 0), 1e-5);
  const double both = relative_residual(stiffness.K, mask, rhs, x, Eigen::ArrayXd::Zero(2));
  EXPECT_EQ(both, std::max(residual(0, 0), residual(1, 0)));
  for (Index i = 0; i < x.rows(); ++i) stiffness.K.coeffRef(i, i) *= 1 + 1e-3;
  EXPECT_EQ(relative_residual(stiffness.K, mask, rhs, x, Eigen::ArrayXd::Zero(2)), both);
  x(Squashed::n + 5, 0) += 1e-6;
  EXPECT_GE(residual(0, kRounding), 1);
}

} // namespace
} // namespace dirichlet
