// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/solver.h"

#include <algorithm>
#include <new>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/OrderingMethods>

#include "dirichlet/error.h"
#include "for_row.h"
#include "message.h"
#include "parallel.h"
#include "solver/factor.h"
#include "solver/ordering.h"
#include "stopwatch.h"

namespace dirichlet {
namespace {

Index count_free(const Mask& mask) {
  return static_cast<Index>(std::count(mask.begin(), mask.end(), 0));
}

/// The pattern of a compressed matrix, its diagonal included.
Graph graph_of(const SparseMatrix& K) {
  return {{K.outerIndexPtr(), static_cast<std::size_t>(K.rows()) + 1},
          {K.innerIndexPtr(), static_cast<std::size_t>(K.nonZeros())}};
}

/// Entries of the lower triangle of the injected twin.
std::int64_t count_injected(const SparseMatrix& K, const Mask& mask) {
  const auto fixed = [&](Index i) { return mask[static_cast<std::size_t>(i)] != 0; };
  std::int64_t count = 0;
  for (Index i = 0; i < K.rows(); ++i)
    for_row(K, i, [&](Index j, double) { count += j == i || (j < i && !fixed(i) && !fixed(j)); });
  return count;
}

/// Dissection pays on large surfaces; on small ones minimum degree is as good and quicker.
std::vector<Index> elimination_order(const SparseMatrix& K) {
  constexpr Index kSmall = 50'000;
  const Graph graph = graph_of(K);
  if (K.rows() > kSmall)
    return fill_reducing_order(graph.offsets, graph.neighbours, static_cast<unsigned>(core_count()));
  const Eigen::Map<const SymmetricMatrix> columns(K.rows(), K.cols(), K.nonZeros(), K.outerIndexPtr(),
                                                  K.innerIndexPtr(), K.valuePtr()); // rows are columns by symmetry
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> order;
  Eigen::AMDOrdering<Index>()(columns.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

class DirectSolver final : public Solver {
 public:
  DirectSolver(const SparseMatrix& K, const Mask& mask) : K_(K), mask_(mask) {
    Stopwatch watch;
    symbolic_ = std::make_shared<const SymbolicFactor>(analyse(graph_of(K), elimination_order(K)));
    auto matrix = std::make_shared<const OrderedMatrix>(order_matrix(K, *symbolic_));
    statistics_.unknowns = count_free(mask);
    statistics_.nonzeros = count_injected(K, mask);
    statistics_.factor_nonzeros = symbolic_->factor_size();
    factor_ = std::make_unique<Factor<double>>(symbolic_, std::move(matrix), 0); // nothing is repainted yet
    Mask fixed(mask.size());
    for (std::size_t v = 0; v < mask.size(); ++v) fixed[static_cast<std::size_t>(symbolic_->position[v])] = mask[v];
    factor_->factor(fixed);
    statistics_.factor_seconds = watch.seconds();
  }

  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& prescribed, Index& iterations) const override {
    iterations = 0;
    Eigen::MatrixXd x = inject_right_hand_side(K_, mask_, prescribed);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> ordered(x.rows(), x.cols());
    for (Index i = 0; i < x.rows(); ++i) ordered.row(i) = x.row(symbolic_->order[static_cast<std::size_t>(i)]);
    factor_->solve({ordered.data(), static_cast<std::size_t>(ordered.size())}, static_cast<Index>(x.cols()));
    for (Index i = 0; i < x.rows(); ++i) x.row(symbolic_->order[static_cast<std::size_t>(i)]) = ordered.row(i);
    return x;
  }

  [[nodiscard]] const SolverStatistics& statistics() const override { return statistics_; }

 private:
  const SparseMatrix& K_;
  Mask mask_;
  SolverStatistics statistics_;
  std::shared_ptr<const SymbolicFactor> symbolic_;
  std::unique_ptr<Factor<double>> factor_;
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
