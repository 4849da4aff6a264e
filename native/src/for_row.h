// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// Calls visit(column, value) for the entries of a row of a compressed matrix, in the order in which they are stored.
template <class Matrix, class Visit>
void for_row(const Matrix& A, Index row, Visit visit) {
  const Index* column = A.innerIndexPtr();
  const auto* value = A.valuePtr();
  for (Index e = A.outerIndexPtr()[row]; e < A.outerIndexPtr()[row + 1]; ++e) visit(column[e], value[e]);
}

} // namespace dirichlet
