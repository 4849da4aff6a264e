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

/// Makes a Laplacian fit for a method that subtracts from a stored diagonal. Weights of surfaces, which have no unit,
/// become no larger than 2^26, and rows sum to 0 again: what so large a weight joins is one to half the digits of a
/// double in any case, and the other half is left to the weights beside it.
/// \param method  for the message
/// \returns  whether digits may be lost all the same: of parts that hang on the rest by weights 1e-8 of the largest,
/// and
///           of vertices between others that they were so close to, by weights that had differed
/// \throws SolverError  weak links of 1e-13, where no digit is certain
bool limit_weights(SparseMatrix& K, const char* method);

} // namespace dirichlet
