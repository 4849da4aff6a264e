// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// Strong Dirichlet conditions injected into a square operator: the heart of the method, with no mesh in it.
///
/// M = diag(mask) is 1 where a value is painted. Mask and value stay apart, so that a patch may have any value, 0 too.
/// The matrices keep all n unknowns and have identity rows where painted, hence φ = b there bit for bit.
using Mask = std::vector<std::uint8_t>; ///< (n,) 0 or 1

/// The paper's Dirichlet–Laplacian matrix (I − M) L + M: square, not symmetric. Cost: O(non-zeros).
/// Source: "Dirichlet Surface Isolines", eq. (3). \throws InputError  mask of a wrong length.
SparseMatrix inject(const SparseMatrix& L, const Mask& mask);

/// Its symmetric positive definite twin (I − M) K (I − M) + M for a symmetric K: same solution with the right-hand side
/// below. Only the lower triangle is stored (rows = columns by symmetry, hence column-major). Cost: O(non-zeros).
Eigen::SparseMatrix<double, Eigen::ColMajor, Index> inject_symmetric(const SparseMatrix& K, const Mask& mask);

/// The right-hand side that goes with it, M b + (I − M)(s − K M b), for k fields at once.
/// \param prescribed  (n, k): the value b where painted, the source s (already times mass) where free.
Eigen::MatrixXd inject_right_hand_side(const SparseMatrix& K, const Mask& mask, const Eigen::MatrixXd& prescribed);

/// What the paint cuts the surface into: the connected pieces of the free vertices. Each is a Dirichlet problem of its
/// own, ruled by the painted vertices at its rim; a piece without a rim has no equation and its field is undefined.
struct FreeRegions {
  static constexpr Index kPainted = -1;
  std::vector<Index> label;        ///< (n,) piece, numbered by lowest vertex; kPainted where painted
  std::vector<std::uint8_t> ruled; ///< (count,) 1: touches paint
};

/// Cost: O(n + non-zeros).
FreeRegions free_regions(const SparseMatrix& K, const Mask& mask);

} // namespace dirichlet
