// SPDX-License-Identifier: GPL-3.0-or-later
#include "lump.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace dirichlet::ordering {

void order_lump(const Graph& graph, Index* order) {
  using Pattern = Eigen::SparseMatrix<signed char, Eigen::ColMajor, Index>;
  Pattern pattern(graph.size, graph.size);
  pattern.resizeNonZeros(graph.offsets[graph.size]);
  std::copy_n(graph.offsets, graph.size + 1, pattern.outerIndexPtr());
  std::copy_n(graph.neighbours, pattern.nonZeros(), pattern.innerIndexPtr());
  std::fill_n(pattern.valuePtr(), pattern.nonZeros(), static_cast<signed char>(1));
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> eliminated;
  Eigen::AMDOrdering<Index>()(pattern.selfadjointView<Eigen::Lower>(), eliminated); // takes rows that are not sorted
  std::copy_n(eliminated.indices().data(), graph.size, order);
}

} // namespace dirichlet::ordering
