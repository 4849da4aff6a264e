// SPDX-License-Identifier: GPL-3.0-or-later
#include "lump.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace dirichlet::ordering {

std::vector<Index> order_lump(const Graph& graph) {
  using Pattern = Eigen::SparseMatrix<signed char, Eigen::ColMajor, Index>;
  Pattern pattern(graph.size, graph.size);
  const Index count = graph.offsets[graph.size] + graph.size;
  pattern.reserve(count + count / 5 + 2 * graph.size); // the room that the elimination needs
  pattern.resizeNonZeros(count);
  Index end = 0;
  for (Index v = 0; v < graph.size; ++v) {
    pattern.outerIndexPtr()[v] = end;
    pattern.innerIndexPtr()[end++] = v; // Eigen takes a column without its diagonal for a dense one
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (graph.neighbours[e] != v) pattern.innerIndexPtr()[end++] = graph.neighbours[e];
  }
  pattern.outerIndexPtr()[graph.size] = end;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> eliminated;
  Eigen::internal::minimum_degree_ordering(pattern, eliminated); // AMDOrdering would copy the pattern first
  return {eliminated.indices().data(), eliminated.indices().data() + graph.size};
}

} // namespace dirichlet::ordering
