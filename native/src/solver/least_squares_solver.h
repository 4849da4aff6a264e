// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "dirichlet/solver.h"

namespace dirichlet {

/// The paper's method: conjugate gradients on LᵀL for the raw, unsymmetric matrix L with its identity rows. Cost: O(n)
/// per step, and as many steps as the condition number of L: a reference, not a tool.
std::unique_ptr<Solver> make_least_squares_solver(SparseMatrix&& K, const SolverOptions& options);

} // namespace dirichlet
