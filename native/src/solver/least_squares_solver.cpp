// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/least_squares_solver.h"

#include <algorithm>
#include <numeric>

#include <Eigen/IterativeLinearSolvers>

#include "dirichlet/error.h"
#include "index.h"
#include "message.h"

namespace dirichlet {
namespace {

class LeastSquaresSolver final : public Solver {
 public:
  LeastSquaresSolver(SparseMatrix&& K, const SolverOptions& options)
      : order_(at(static_cast<Index>(K.rows()))), tolerance_(options.tolerance.value_or(1e-14)),
        max_iterations_(options.max_iterations.value_or(20 * static_cast<Index>(K.rows()) + 1000)) {
    K_.swap(K); // Eigen 3.4 copies what is moved
    std::iota(order_.begin(), order_.end(), Index{0});
    statistics_.method = Method::least_squares_cg;
    statistics_.nonzeros = K_.nonZeros();
  }

  [[nodiscard]] SparseView matrix() const override { return K_; }
  [[nodiscard]] std::span<const Index> order() const override { return order_; }
  [[nodiscard]] const SolverStatistics& statistics() const override { return statistics_; }

  double inject(const Mask& mask) override {
    if (mask == mask_) return 0;
    mask_.clear(); // until all is done
    L_ = dirichlet::inject(random_walk(K_), mask);
    mask_ = mask;
    return 1;
  }

  Index solve(const Block& rhs, Block& x) const override {
    // L is D⁻¹ times the stiffness; its right-hand side is that of the twin with the painted columns moved back.
    Block prescribed = rhs;
    for (Index i = 0; i < K_.rows(); ++i) {
      if (mask_[at(i)] != 0) continue;
      for (SparseMatrix::InnerIterator entry(K_, i); entry; ++entry)
        if (mask_[at(static_cast<Index>(entry.col()))] != 0) prescribed.row(i) += entry.value() * rhs.row(entry.col());
      prescribed.row(i) /= K_.coeff(i, i);
    }
    Eigen::LeastSquaresConjugateGradient<SparseMatrix> cg; // made here: it keeps the figures of its last run
    cg.setTolerance(tolerance_);
    cg.setMaxIterations(max_iterations_);
    cg.compute(L_);
    Index iterations = 0;
    for (Eigen::Index column = 0; column < x.cols(); ++column) {
      x.col(column) = cg.solve(prescribed.col(column)).eval();
      if (cg.info() != Eigen::Success)
        throw SolverError(message("least-squares conjugate gradients stopped at ", cg.error(), " after ",
                                  cg.iterations(), " steps, short of the tolerance ", tolerance_));
      iterations = std::max(iterations, static_cast<Index>(cg.iterations()));
    }
    return iterations;
  }

 private:
  SparseMatrix K_;
  std::vector<Index> order_;
  SparseMatrix L_; ///< injected
  Mask mask_;      ///< that is injected; empty if none is
  double tolerance_;
  Index max_iterations_;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<Solver> make_least_squares_solver(SparseMatrix&& K, const SolverOptions& options) {
  return std::make_unique<LeastSquaresSolver>(std::move(K), options);
}

} // namespace dirichlet
