// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "dirichlet/solver.h"
#include "solver/symbolic.h"

namespace dirichlet {

/// What of a direct solver depends on the matrix's pattern alone.
struct Analysis {
  std::shared_ptr<const SymbolicFactor> symbolic;
  double seconds = 0;
};

/// Ordering and symbolic analysis. Cost: O(n log n) on surfaces.
Analysis analyse_pattern(const SparseMatrix& K, const CancelToken& cancel);

/// Bytes that a solver needs at least, matrix included. \param entries  of the matrix
std::int64_t direct_solver_bytes(const SymbolicFactor& symbolic, std::int64_t entries, Precision precision);

/// Multifrontal Cholesky of the injected twin, in float64, or in float32 with conjugate gradients that refine it.
/// \param weak_links  for its statistics
std::unique_ptr<Solver> make_direct_solver(const SparseMatrix& K, const Analysis& analysis, std::int64_t memory_budget,
                                           const SolverOptions& options, bool weak_links);

} // namespace dirichlet
