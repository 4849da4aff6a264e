// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/injection.h"
#include "solver/factor.h"

namespace dirichlet {

/// Solves with the injected twin in double precision by conjugate gradients, preconditioned by its factor in single
/// precision: two or three steps where the factor is good, more where the matrix is ill-conditioned. For k right-hand
/// sides at once, each with step lengths of its own.
/// \param x  (n, k) the solution; what it held is not read
/// \returns  steps
/// \throws SolverError  a column short of ‖rhs − A x‖ ≤ tolerance ‖rhs‖ after max_iterations
Index refine(const SparseView& K, const Mask& mask, const Factor<float>& factor, const Block& rhs, Block& x,
             double tolerance, Index max_iterations);

} // namespace dirichlet
