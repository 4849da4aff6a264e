// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/symbolic.h"

namespace dirichlet {

/// Columns renumbered so that every subtree of the elimination tree is one run, children before their parents.
struct EliminationTree {
  std::vector<Index> order;  ///< (n,) the vertex at every position
  std::vector<Index> parent; ///< (n,) position of the first entry below the diagonal of a column; -1 at a root
  std::vector<Index> count;  ///< (n,) entries of every column, its diagonal included
};

/// Cost: O(entries α(n)).
EliminationTree eliminate(const Graph& graph, std::span<const Index> elimination_order);

} // namespace dirichlet
