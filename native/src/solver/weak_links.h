// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// What the sizes of a matrix's weights ask of a solver, up to the rounding of rows that sum to 0. Cost: O(non-zeros).

/// Whether pivots are to be summed: a Laplacian, some of whose weights are 1e4 times others.
bool has_uneven_weights(const SparseMatrix& K);

/// Whether some part of a Laplacian hangs on the rest only by weights below `ratio` of the largest, as across very thin
/// faces. About as many digits are lost by all that subtracts from a stored diagonal.
bool has_weak_links(const SparseMatrix& K, double ratio);

/// The same for 1e-8, where single precision begins to see it.
/// \throws SolverError  for 1e-13, where no digit is certain; names the method
bool check_weak_links(const SparseMatrix& K, const char* method);

/// Makes weights of surfaces, which have no unit, no larger than 2^26, and rows sum to 0 again. What so large a weight
/// joins is one to half the digits of a double in any case, and the other half is left to the weights beside it.
void limit_weights(SparseMatrix& K);

} // namespace dirichlet
