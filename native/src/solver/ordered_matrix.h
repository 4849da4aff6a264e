// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/buffer.h"
#include "dirichlet/laplacian.h"
#include "solver/symbolic.h"

namespace dirichlet {

/// A symmetric pattern renumbered by an order of elimination: row i belongs to the vertex order[i]. Rows are whole
/// (both triangles), in compressed form; columns on the left of the diagonal come before the others, else in any order.
///
/// Dissection puts neighbours close together, so what walks along rows and looks up columns stays in the cache, however
/// the surface was numbered.
struct OrderedPattern {
  std::vector<Index> offsets; ///< (n + 1,) row i has the entries offsets[i] … offsets[i + 1)
  std::vector<Index> upper;   ///< (n,) its first entry on or right of the diagonal
  Buffer<Index> columns;

  [[nodiscard]] Index size() const { return static_cast<Index>(upper.size()); }
};

/// A symmetric matrix renumbered likewise.
struct OrderedMatrix : OrderedPattern {
  Buffer<double> values; ///< beside the columns
};

/// \param order  a permutation of the vertices, \param position  its inverse. Cost: O(entries), on all threads.
OrderedPattern order_pattern(const Graph& graph, std::span<const Index> order, std::span<const Index> position);

/// \param K  compressed, with a symmetric pattern; \param order  as above. Cost: O(entries), on all threads.
OrderedMatrix order_matrix(const SparseMatrix& K, std::span<const Index> order);

/// position[order[k]] = k
std::vector<Index> inverse_permutation(std::span<const Index> order);

} // namespace dirichlet
