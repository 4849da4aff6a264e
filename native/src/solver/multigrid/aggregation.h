// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/injection.h"

namespace dirichlet::multigrid {

/// The strongest attraction of every row: the largest −A(i,j) among free vertices, 0 for a painted or a lonely row.
/// \param mask  (n,) 1 where painted, or empty where nothing is. Cost: O(non-zeros).
std::vector<double> strongest_attractions(const SparseMatrix& A, const Mask& mask);

/// Below this share of its row's strongest attraction a neighbour counts for nothing in the coarse space: across such
/// an edge the error does not get smooth.
inline constexpr double kWeakShare = 0.25;

struct Aggregates {
  static constexpr Index kNone = -1;
  std::vector<Index> label; ///< (n,) the aggregate of every row, or kNone for those that relaxation alone can serve
  Index count = 0;
};

/// Gathers rows with all their strong neighbours, in surface meshes about eight, until no whole neighbourhood is left;
/// the rest joins the neighbour that attracts it most (Vaněk, Mandel & Brezina 1996). Every aggregate has at least two
/// members, so a hierarchy ends. Cost: O(non-zeros), in one thread, in the order of the rows.
Aggregates aggregate(const SparseMatrix& A, std::span<const double> strongest);

} // namespace dirichlet::multigrid
