// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/least_squares_solver.h"

#include <algorithm>

#include <Eigen/IterativeLinearSolvers>

#include "dirichlet/error.h"
#include "message.h"
#include "solver/iterative_solver.h"

namespace dirichlet {
namespace {

/// Eigen's loop asks for it once in every step: the place where work that was cancelled can stop.
class CancellablePreconditioner : public Eigen::LeastSquareDiagonalPreconditioner<double> {
 public:
  void set_cancel(const CancelToken& cancel) { cancel_ = cancel; }

  template <typename Vector>
  auto solve(const Eigen::MatrixBase<Vector>& b) const {
    cancel_.check();
    return Eigen::LeastSquareDiagonalPreconditioner<double>::solve(b);
  }

 private:
  CancelToken cancel_;
};

class LeastSquaresSolver final : public IterativeSolver {
 public:
  LeastSquaresSolver(SparseMatrix&& K, const SolverOptions& options)
      : IterativeSolver(std::move(K), Method::least_squares_cg, options.method, /*analysis_seconds=*/0),
        tolerance_(options.tolerance.value_or(1e-14)),
        max_iterations_(options.max_iterations.value_or(20 * static_cast<Index>(stiffness().rows()) + 1000)),
        cancel_(options.cancel) {}

  Index solve(const Block& rhs, Block& x) const override {
    // L is D⁻¹ times the stiffness; its right-hand side is that of the twin with the painted columns moved back.
    const SparseMatrix& K = stiffness();
    const auto painted = [this](Eigen::Index i) { return mask()[static_cast<std::size_t>(i)] != 0; };
    Block prescribed = rhs;
    for (Index i = 0; i < K.rows(); ++i) {
      if (painted(i)) continue;
      for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry)
        if (painted(entry.col())) prescribed.row(i) += entry.value() * rhs.row(entry.col());
      prescribed.row(i) /= K.coeff(i, i);
    }
    // Made here: it keeps the figures of its last run.
    Eigen::LeastSquaresConjugateGradient<SparseMatrix, CancellablePreconditioner> cg;
    cg.preconditioner().set_cancel(cancel_);
    cg.setTolerance(tolerance_);
    cg.setMaxIterations(max_iterations_);
    cg.compute(L_);
    Index iterations = 0;
    x.resize(rhs.rows(), rhs.cols());
    for (Eigen::Index column = 0; column < x.cols(); ++column) {
      cancel_.check();
      x.col(column) = cg.solve(prescribed.col(column)).eval();
      if (cg.info() != Eigen::Success)
        throw SolverError(message("least-squares conjugate gradients stopped at ", roughly(cg.error()), " after ",
                                  counted(cg.iterations(), "step"), ", short of the tolerance ", tolerance_,
                                  "; allow more steps or a larger tolerance, or take the direct method"));
      iterations = std::max(iterations, static_cast<Index>(cg.iterations()));
    }
    return iterations;
  }

 private:
  void set_up(const Mask& mask) override {
    cancel_.check();
    L_ = dirichlet::inject(random_walk(stiffness()), mask);
  }

  SparseMatrix L_; ///< injected
  double tolerance_;
  Index max_iterations_;
  CancelToken cancel_;
};

} // namespace

std::unique_ptr<Solver> make_least_squares_solver(SparseMatrix&& K, const SolverOptions& options) {
  return std::make_unique<LeastSquaresSolver>(std::move(K), options);
}

} // namespace dirichlet
