// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/multigrid_solver.h"

#include <algorithm>
#include <utility>

#include "solver/iterative_solver.h"
#include "solver/multigrid.h"

namespace dirichlet {
namespace {

class MultigridSolver final : public IterativeSolver {
 public:
  MultigridSolver(SparseMatrix&& K, const SolverOptions& options, double analysis_seconds)
      : IterativeSolver(std::move(K), Method::multigrid, options.method, analysis_seconds),
        tolerance_(options.tolerance.value_or(kTwinTolerance)), to_rounding_(!options.tolerance),
        max_iterations_(options.max_iterations.value_or(kMostTwinIterations)), cancel_(options.cancel) {}

  Index solve(const Block& rhs, Block& x) const override {
    if (x.rows() != rhs.rows() || x.cols() != rhs.cols()) x = Block::Zero(rhs.rows(), rhs.cols());
    Index iterations = 0;
    Eigen::VectorXd b, guess;
    for (Eigen::Index column = 0; column < rhs.cols(); ++column) {
      b = rhs.col(column);
      guess = x.col(column);
      const auto span = [](auto& vector) { return std::span(vector.data(), static_cast<std::size_t>(vector.size())); };
      const auto result =
          multigrid_->solve(span(std::as_const(b)), span(guess), tolerance_, max_iterations_, to_rounding_);
      iterations = std::max(iterations, result.iterations);
      x.col(column) = guess;
    }
    return iterations;
  }

 private:
  void set_up(const Mask& mask) override {
    multigrid_.reset(); // before the next takes its memory
    multigrid_ = std::make_unique<const Multigrid>(stiffness(), mask, cancel_);
  }

  std::unique_ptr<const Multigrid> multigrid_; ///< the hierarchy of the mask
  double tolerance_;
  bool to_rounding_; ///< no tolerance was asked for
  Index max_iterations_;
  CancelToken cancel_;
};

} // namespace

std::unique_ptr<Solver> make_multigrid_solver(SparseMatrix&& K, const SolverOptions& options, double analysis_seconds) {
  return std::make_unique<MultigridSolver>(std::move(K), options, analysis_seconds);
}

} // namespace dirichlet
