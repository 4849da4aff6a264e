// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "dirichlet/solver.h"

namespace dirichlet {

/// Conjugate gradients on the injected twin with a multigrid preconditioner: memory O(n), for surfaces whose factor
/// does not fit. A new painting needs a new hierarchy, and starts from the last field.
/// \param analysis_seconds  spent before it was chosen, for its statistics
std::unique_ptr<Solver> make_multigrid_solver(SparseMatrix&& K, const SolverOptions& options,
                                              double analysis_seconds = 0);

} // namespace dirichlet
