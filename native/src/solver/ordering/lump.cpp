// SPDX-License-Identifier: GPL-3.0-or-later
#include "lump.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace dirichlet::ordering {

void order_lump(const Graph& graph, Index* order) {
  using Pattern = Eigen::SparseMatrix<signed char, Eigen::ColMajor, Index>;
  Pattern pattern(graph.size, graph.size);
  pattern.resizeNonZeros(graph.offsets[graph.size] + graph.size);
  Index end = 0;
  for (Index v = 0; v < graph.size; ++v) {
    pattern.outerIndexPtr()[v] = end;
    pattern.innerIndexPtr()[end++] = v; // Eigen takes a column without its diagonal for a dense one
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      pattern.innerIndexPtr()[end++] = graph.neighbours[e];
  }
  pattern.outerIndexPtr()[graph.size] = end;
  std::fill_n(pattern.valuePtr(), end, static_cast<signed char>(1));
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> eliminated;
  Eigen::AMDOrdering<Index>()(pattern.selfadjointView<Eigen::Lower>(), eliminated); // takes rows that are not sorted
  std::copy_n(eliminated.indices().data(), graph.size, order);
}

} // namespace dirichlet::ordering
