// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// Calls visit(column, value) for the entries of a row of a compressed matrix, in ascending columns.
template <class Real, class Visit>
void for_row(const Eigen::SparseMatrix<Real, Eigen::RowMajor, Index>& A, Index row, Visit visit) {
  const Index* column = A.innerIndexPtr();
  const Real* value = A.valuePtr();
  for (Index e = A.outerIndexPtr()[row]; e < A.outerIndexPtr()[row + 1]; ++e) visit(column[e], value[e]);
}

} // namespace dirichlet
