// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

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

/// A symmetric matrix by its lower triangle alone, in compressed columns.
using SymmetricMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// Its symmetric positive definite twin (I − M) K (I − M) + M for a symmetric K: same solution with the right-hand side
/// below. Cost: O(non-zeros).
SymmetricMatrix inject_symmetric(const SparseMatrix& K, const Mask& mask);

/// k vectors side by side: (n, k), one row per unknown.
using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The right-hand side that goes with it, M b + (I − M)(s − K M b), for k fields at once.
/// \param prescribed  (n, k): the value b where painted, the source s (already times mass) where free.
/// Cost: O(n k + non-zeros in painted rows).
Block inject_right_hand_side(const SparseView& K, const Mask& mask, Block prescribed);

/// What the paint cuts the surface into: the connected pieces of the free vertices. Each is a Dirichlet problem of its
/// own, ruled by the painted vertices at its rim; a piece without a rim has no equation and its field is undefined.
struct FreeRegions {
  static constexpr Index kPainted = -1;
  std::vector<Index> label; ///< (n,) piece, numbered by lowest vertex; kPainted where painted
  Index count = 0;
  /// Region and painted vertex of every pair that meets across an edge (a pair as often as it has edges).
  std::vector<std::array<Index, 2>> rim;
};

/// Cost: O(n + non-zeros).
FreeRegions free_regions(const SparseView& K, const Mask& mask);

} // namespace dirichlet
