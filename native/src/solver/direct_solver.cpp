// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/direct_solver.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "dirichlet/error.h"
#include "for_row.h"
#include "index.h"
#include "parallel.h"
#include "solver/factor.h"
#include "solver/iterative_solver.h"
#include "solver/ordered_matrix.h"
#include "solver/ordering.h"
#include "solver/refinement.h"
#include "solver/weak_links.h"
#include "stopwatch.h"

namespace dirichlet {
namespace {

/// The pattern of a compressed matrix, its diagonal included.
Graph graph_of(const SparseMatrix& K) {
  return {{K.outerIndexPtr(), at(static_cast<Index>(K.rows())) + 1},
          {K.innerIndexPtr(), static_cast<std::size_t>(K.nonZeros())}};
}

/// Dissection pays on large surfaces: minimum degree is quicker, but on regular ones fills up to three times as much.
std::vector<Index> elimination_order(const Graph& graph, const CancelToken& cancel) {
  constexpr Index kSmall = 25'000;
  return graph.size() <= kSmall
             ? minimum_degree_order(graph.offsets, graph.neighbours)
             : fill_reducing_order(graph.offsets, graph.neighbours, static_cast<unsigned>(core_count()), cancel);
}

Eigen::Map<const SparseMatrix> view(const OrderedMatrix& matrix) {
  return {matrix.size(),         matrix.size(),         matrix.offsets.back(),
          matrix.offsets.data(), matrix.columns.data(), matrix.values.data()};
}

template <class Real>
class DirectSolver final : public Solver {
 public:
  DirectSolver(const SparseMatrix& K, const Analysis& analysis, std::int64_t most_kept, const SolverOptions& options,
               bool weak_links)
      : symbolic_(analysis.symbolic), matrix_(std::make_shared<const OrderedMatrix>(order_matrix(K, symbolic_->order))),
        statistics_{.method = Method::direct,
                    .nonzeros = K.nonZeros(),
                    .factor_nonzeros = symbolic_->factor_size(),
                    .factor_bytes = Factor<Real>::bytes_needed(*symbolic_, K.nonZeros(), 0),
                    .analysis_seconds = analysis.seconds,
                    .sums_pivots = has_uneven_weights(K),
                    .weak_links = weak_links},
        factor_(symbolic_, matrix_, statistics_.sums_pivots ? Pivots::summed : Pivots::subtracted, most_kept,
                options.cancel),
        tolerance_(options.tolerance.value_or(kTwinTolerance)),
        max_iterations_(options.max_iterations.value_or(kMostTwinIterations)) {}

  [[nodiscard]] SparseView matrix() const override { return view(*matrix_); }
  [[nodiscard]] std::span<const Index> order() const override { return symbolic_->order; }
  [[nodiscard]] const SolverStatistics& statistics() const override { return statistics_; }

  double inject(const Mask& mask) override {
    if (mask == mask_) return 0;
    const Mask last = std::exchange(mask_, {}); // none until all is done
    double repeated = 1;
    if (last.empty())
      factor_.factor(mask);
    else
      repeated = factor_.refactor(mask, changed_columns(last, mask));
    mask_ = mask;
    return repeated;
  }

  Index solve(const Block& rhs, Block& x) const override {
    const auto k = static_cast<Index>(rhs.cols());
    if constexpr (std::is_same_v<Real, double>) {
      x = rhs;
      factor_.solve({x.data(), static_cast<std::size_t>(x.size())}, k);
      return 0;
    } else {
      return refine(matrix(), mask_, factor_, rhs, x, tolerance_, max_iterations_);
    }
  }

 private:
  /// Columns of the twin that differ: those whose flag does, and their neighbours, which lose or gain an entry.
  [[nodiscard]] std::vector<Index> changed_columns(const Mask& last, const Mask& mask) const {
    std::vector<Index> columns;
    for (std::size_t row = 0; row < mask.size(); ++row)
      if (mask[row] != last[row])
        for_row(view(*matrix_), static_cast<Index>(row), [&](Index j, double) { columns.push_back(j); });
    return columns;
  }

  std::shared_ptr<const SymbolicFactor> symbolic_;
  std::shared_ptr<const OrderedMatrix> matrix_;
  SolverStatistics statistics_;
  Factor<Real> factor_;
  Mask mask_; ///< the one that is factored; empty if none is
  double tolerance_;
  Index max_iterations_;
};

} // namespace

Analysis analyse_pattern(const SparseMatrix& K, const CancelToken& cancel) {
  const Stopwatch watch;
  Analysis analysis;
  const Graph graph = graph_of(K);
  const std::vector<Index> order = elimination_order(graph, cancel);
  cancel.check();
  analysis.symbolic = std::make_shared<const SymbolicFactor>(analyse(graph, order));
  cancel.check();
  analysis.seconds = watch.seconds();
  return analysis;
}

std::int64_t direct_solver_bytes(const SymbolicFactor& symbolic, std::int64_t entries, Precision precision) {
  return precision == Precision::float32 ? Factor<float>::bytes_needed(symbolic, entries, 0)
                                         : Factor<double>::bytes_needed(symbolic, entries, 0);
}

std::unique_ptr<Solver> make_direct_solver(const SparseMatrix& K, const Analysis& analysis, std::int64_t memory_budget,
                                           const SolverOptions& options, bool weak_links) {
  // Beyond about half the factor, more kept update matrices hardly spare a stroke any work.
  const std::int64_t needed = direct_solver_bytes(*analysis.symbolic, K.nonZeros(), options.precision);
  const std::int64_t most_kept = std::clamp<std::int64_t>(memory_budget - needed, 0, needed / 2);
  if (options.precision == Precision::float32)
    return std::make_unique<DirectSolver<float>>(K, analysis, most_kept, options, weak_links);
  return std::make_unique<DirectSolver<double>>(K, analysis, most_kept, options, weak_links);
}

} // namespace dirichlet
