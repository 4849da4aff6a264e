// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "aggregation.h"

namespace dirichlet::multigrid {

/// Between two levels. Its weights lie in [0, 1] and belong to the preconditioner alone: single precision will do.
using Transfer = Eigen::SparseMatrix<float, Eigen::RowMajor, Index>;

/// Smoothed aggregation: the indicator vectors of the aggregates after one step of damped Jacobi with the strong part
/// of A. Rows without an aggregate are empty. (rows of A, aggregates)
/// Source: Vaněk, Mandel & Brezina 1996, "Algebraic multigrid by smoothed aggregation". Cost: O(non-zeros).
Transfer smoothed_prolongation(const SparseMatrix& A, const Aggregates& aggregates, std::span<const double> strongest);

/// The Galerkin product R A Rᵀ for the restriction R = Pᵀ. Cost: O(non-zeros of R times those of a row of A P).
SparseMatrix galerkin_product(const SparseMatrix& A, const Transfer& P, const Transfer& R);

} // namespace dirichlet::multigrid
