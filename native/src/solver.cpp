// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/solver.h"

#include <limits>

#include <utility>

#include "dirichlet/error.h"
#include "memory.h"
#include "message.h"
#include "solver/direct_solver.h"
#include "solver/least_squares_solver.h"
#include "solver/multigrid_solver.h"
#include "solver/weak_links.h"

namespace dirichlet {
namespace {

void check_options(const SolverOptions& options) {
  if (const double tolerance = options.tolerance.value_or(0.5); !(tolerance > 0 && tolerance < 1))
    throw InputError(message("the tolerance has to lie between 0 and 1, not at ", tolerance));
  if (options.max_iterations.value_or(1) < 1)
    throw InputError(message("max_iterations has to be at least 1, not ", *options.max_iterations));
  if (options.memory_budget.value_or(0) < 0)
    throw InputError(message("the memory budget has to be 0 or more bytes, not ", *options.memory_budget));
}

std::unique_ptr<Solver> choose_iterative(SparseMatrix&& K, const SolverOptions& options, double analysis_seconds) {
  return options.method == Method::least_squares_cg ? make_least_squares_solver(std::move(K), options)
                                                    : make_multigrid_solver(std::move(K), options, analysis_seconds);
}

std::unique_ptr<Solver> choose_solver(SparseMatrix&& K, const SolverOptions& options) {
  if (options.method == Method::least_squares_cg || options.method == Method::multigrid)
    return choose_iterative(std::move(K), options, 0);
  const std::int64_t budget = options.memory_budget.value_or(default_memory_budget());
  const Analysis analysis = analyse_pattern(K, options.cancel);
  if (options.method == Method::automatic &&
      direct_solver_bytes(*analysis.symbolic, K.nonZeros(), options.precision) > budget)
    return choose_iterative(std::move(K), options, analysis.seconds);
  const bool weak_links = options.precision == Precision::float32 && limit_weights(K, "a float32 factor");
  return make_direct_solver(K, analysis, budget, options, weak_links);
}

} // namespace

std::int64_t default_memory_budget() {
  const std::int64_t all = physical_memory();
  return all == std::numeric_limits<std::int64_t>::max() ? all : all / 2;
}

std::unique_ptr<Solver> make_solver(SparseMatrix&& K, const SolverOptions& options) {
  check_options(options);
  options.cancel.check();
  return with_memory(static_cast<Index>(K.rows()), [&] { return choose_solver(std::move(K), options); });
}

} // namespace dirichlet
