// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet::testing {

/// What a Cholesky factorisation in a given order costs.
struct EliminationCost {
  double entries = 0; ///< of the factor
  double flops = 0;   ///< the sum of squares of the entries of its columns
};

/// Counts the columns' entries from the row subtrees (Liu 1990). Cost: O(entries of the factor).
inline EliminationCost elimination_cost(std::span<const Index> offsets, std::span<const Index> neighbours,
                                        std::span<const Index> order) {
  const std::size_t n = order.size();
  constexpr Index kNone = -1;
  std::vector<Index> place(n), parent(n, kNone), ancestor(n, kNone), mark(n, kNone), count(n, 1);
  const auto at = [](auto& array, Index i) -> auto& {
    return array[static_cast<std::size_t>(i)];
  };
  for (std::size_t k = 0; k < n; ++k) at(place, order[k]) = static_cast<Index>(k);
  for (Index k = 0; k < static_cast<Index>(n); ++k) {
    const Index v = at(order, k);
    at(mark, k) = k;
    const auto row = neighbours.subspan(static_cast<std::size_t>(at(offsets, v)),
                                        static_cast<std::size_t>(at(offsets, v + 1) - at(offsets, v)));
    for (const Index u : row) // the elimination tree, with shortened paths
      for (Index i = at(place, u); i < k;) {
        const Index next = at(ancestor, i);
        at(ancestor, i) = k;
        if (next == kNone) at(parent, i) = k;
        i = next == kNone ? k : next;
      }
    for (const Index u : row)
      for (Index i = at(place, u); i < k && at(mark, i) != k; i = at(parent, i)) {
        ++at(count, i);
        at(mark, i) = k;
      }
  }
  EliminationCost cost;
  for (const Index c : count) {
    cost.entries += c;
    cost.flops += static_cast<double>(c) * c;
  }
  return cost;
}

} // namespace dirichlet::testing
