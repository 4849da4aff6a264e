// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/laplacian.h"
#include "solver/symbolic.h"

namespace dirichlet {

/// A symmetric matrix renumbered by an order of elimination: row i belongs to the vertex order[i]. Rows are whole (both
/// triangles), in compressed form, columns ascending.
///
/// Dissection puts neighbours close together, so what walks along rows and looks up columns stays in the cache, however
/// the surface was numbered.
struct OrderedMatrix {
  std::vector<Index> offsets; ///< (n + 1,) row i has the entries offsets[i] … offsets[i + 1)
  std::vector<Index> upper;   ///< (n,) its first entry on or right of the diagonal
  std::vector<Index> columns;
  std::vector<double> values;

  [[nodiscard]] Index size() const { return static_cast<Index>(upper.size()); }
};

/// \param K  compressed, with a symmetric pattern. Cost: O(entries log of a row's) on all threads.
OrderedMatrix order_matrix(const SparseMatrix& K, const SymbolicFactor& symbolic);

} // namespace dirichlet
