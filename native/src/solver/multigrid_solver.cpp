// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/multigrid_solver.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "index.h"
#include "solver/multigrid.h"

namespace dirichlet {
namespace {

class MultigridSolver final : public Solver {
 public:
  MultigridSolver(SparseMatrix&& K, const SolverOptions& options, double analysis_seconds)
      : order_(at(static_cast<Index>(K.rows()))), tolerance_(options.tolerance.value_or(1e-10)),
        max_iterations_(options.max_iterations.value_or(500)) {
    K_.swap(K); // Eigen 3.4 copies what is moved
    std::iota(order_.begin(), order_.end(), Index{0});
    statistics_.method = Method::multigrid;
    statistics_.nonzeros = K_.nonZeros();
    statistics_.analysis_seconds = analysis_seconds;
  }

  [[nodiscard]] SparseView matrix() const override { return K_; }
  [[nodiscard]] std::span<const Index> order() const override { return order_; }
  [[nodiscard]] const SolverStatistics& statistics() const override { return statistics_; }

  double inject(const Mask& mask) override {
    if (mask == mask_) return 0;
    mask_.clear();      // until all is done
    multigrid_.reset(); // before the next takes its memory
    multigrid_ = std::make_unique<const Multigrid>(K_, mask);
    mask_ = mask;
    return 1;
  }

  Index solve(const Block& rhs, Block& x) const override {
    Index iterations = 0;
    Eigen::VectorXd b, guess;
    for (Eigen::Index column = 0; column < rhs.cols(); ++column) {
      b = rhs.col(column);
      guess = x.col(column);
      const auto span = [](auto& vector) { return std::span(vector.data(), static_cast<std::size_t>(vector.size())); };
      iterations = std::max(
          iterations, multigrid_->solve(span(std::as_const(b)), span(guess), tolerance_, max_iterations_).iterations);
      x.col(column) = guess;
    }
    return iterations;
  }

 private:
  SparseMatrix K_;
  std::vector<Index> order_;
  std::unique_ptr<const Multigrid> multigrid_;
  Mask mask_; ///< of the hierarchy; empty if there is none
  double tolerance_;
  Index max_iterations_;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<Solver> make_multigrid_solver(SparseMatrix&& K, const SolverOptions& options, double analysis_seconds) {
  return std::make_unique<MultigridSolver>(std::move(K), options, analysis_seconds);
}

} // namespace dirichlet
