// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/solver.h"

#include <algorithm>
#include <new>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include "dirichlet/error.h"
#include "message.h"
#include "parallel.h"
#include "stopwatch.h"

namespace dirichlet {
namespace {

Index count_free(const Mask& mask) {
  return static_cast<Index>(std::count(mask.begin(), mask.end(), 0));
}

class DirectSolver final : public Solver {
 public:
  DirectSolver(const SparseMatrix& K, const Mask& mask) : K_(K), mask_(mask) {
    Stopwatch watch;
    const SymmetricMatrix A = inject_symmetric(K, mask);
    statistics_.unknowns = count_free(mask);
    statistics_.nonzeros = A.nonZeros();
    statistics_.inject_seconds = watch.restart();
    factor_.compute(A);
    if (factor_.info() != Eigen::Success)
      throw SolverError(
          message("the matrix of ", statistics_.unknowns, " unknowns is singular and has no Cholesky factor"));
    statistics_.factor_nonzeros = factor_.matrixL().nestedExpression().nonZeros();
    statistics_.factor_seconds = watch.seconds();
  }

  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& prescribed, Index& iterations) const override {
    iterations = 0;
    Eigen::MatrixXd x = inject_right_hand_side(K_, mask_, prescribed);
    parallel_chunks(static_cast<std::size_t>(x.cols()), 1, [&](std::size_t begin, std::size_t end) {
      for (auto column = static_cast<Eigen::Index>(begin); column < static_cast<Eigen::Index>(end); ++column)
        x.col(column) = factor_.solve(x.col(column)).eval();
    });
    return x;
  }

  [[nodiscard]] const SolverStatistics& statistics() const override { return statistics_; }

 private:
  const SparseMatrix& K_;
  Mask mask_;
  SolverStatistics statistics_;
  Eigen::SimplicialLDLT<SymmetricMatrix, Eigen::Lower> factor_;
};

class LeastSquaresSolver final : public Solver {
 public:
  LeastSquaresSolver(const SparseMatrix& K, const Mask& mask, const SolverOptions& options)
      : diagonal_(K.diagonal()), mask_(mask), tolerance_(options.tolerance),
        max_iterations_(options.max_iterations.value_or(20 * static_cast<Index>(K.rows()) + 1000)) {
    const Stopwatch watch;
    A_ = inject(random_walk(K), mask);
    statistics_.unknowns = count_free(mask);
    statistics_.nonzeros = A_.nonZeros();
    statistics_.inject_seconds = watch.seconds();
  }

  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& prescribed, Index& iterations) const override {
    // The raw matrix is D⁻¹ times the stiffness, so its source is too; painted values stay in its columns.
    Eigen::MatrixXd x = prescribed;
    for (Index i = 0; i < x.rows(); ++i)
      if (mask_[static_cast<std::size_t>(i)] == 0) x.row(i) /= diagonal_[i];

    Eigen::LeastSquaresConjugateGradient<SparseMatrix> cg; // made here: it keeps the figures of its last run
    cg.setTolerance(tolerance_);
    cg.setMaxIterations(max_iterations_);
    cg.compute(A_);
    iterations = 0;
    for (Eigen::Index column = 0; column < x.cols(); ++column) {
      x.col(column) = cg.solve(x.col(column)).eval();
      if (cg.info() != Eigen::Success)
        throw SolverError(message("least-squares conjugate gradients stopped at ", cg.error(), " after ",
                                  cg.iterations(), " steps, short of the tolerance ", tolerance_));
      iterations = std::max(iterations, static_cast<Index>(cg.iterations()));
    }
    return x;
  }

  [[nodiscard]] const SolverStatistics& statistics() const override { return statistics_; }

 private:
  SparseMatrix A_;
  Eigen::VectorXd diagonal_;
  Mask mask_;
  double tolerance_;
  Index max_iterations_;
  SolverStatistics statistics_;
};

void check_options(const SolverOptions& options) {
  if (!(options.tolerance > 0 && options.tolerance < 1))
    throw InputError(message("the tolerance has to lie between 0 and 1, not at ", options.tolerance));
  if (options.max_iterations.value_or(1) < 1)
    throw InputError(message("max_iterations has to be at least 1, not ", *options.max_iterations));
}

} // namespace

std::unique_ptr<Solver> make_solver(const SparseMatrix& K, const Mask& mask, const SolverOptions& options) {
  check_options(options);
  try {
    if (options.method == Method::direct) return std::make_unique<DirectSolver>(K, mask);
    return std::make_unique<LeastSquaresSolver>(K, mask, options);
  } catch (const std::bad_alloc&) {
    throw SolverError(message("there is not enough memory to factor ", count_free(mask), " unknowns"));
  }
}

} // namespace dirichlet
