// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/injection.h"

namespace dirichlet {

/// The injected twin A = (I − M) K (I − M) + M as an operator, without being built: what the residual and iterations
/// need. All sums are taken in one order, whatever the number of threads.

/// y = A x for k vectors at once; y gets the size of x. Cost: O(k non-zeros), on all cores.
void multiply_twin(const SparseView& K, const Mask& mask, const Block& x, Block& y);

/// (k,) dot products of the columns of a and b over the rows that are not fixed.
Eigen::ArrayXd free_dots(const Mask& mask, const Block& a, const Block& b);

/// a += b diag(factors), for factors (k,).
void add_columns(const Block& b, const Eigen::ArrayXd& factors, Block& a);

/// ‖rhs − A x‖ / ‖rhs‖ over the rows that are not fixed, or the norm above alone where rhs is 0: the worst column. NaN
/// if x has a number there that is not finite. Rows of K are taken to sum to 0, and the diagonal is not read.
/// \param error  (k,) of the numbers of a column of x: what it comes to, times a row of K, is not counted. Where some
///               weights are much larger than those to fixed rows, that may be more than ‖rhs‖ for rounding alone.
/// Cost: O(k non-zeros), on all cores, hardly any memory.
double relative_residual(const SparseView& K, const Mask& mask, const Block& rhs, const Block& x,
                         const Eigen::ArrayXd& error);

} // namespace dirichlet
