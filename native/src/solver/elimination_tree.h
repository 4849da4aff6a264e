// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/ordered_matrix.h"

namespace dirichlet {

/// Columns renumbered once more, in postorder: every subtree of the elimination tree is one run, children before their
/// parents. That changes no fill.
struct EliminationTree {
  std::vector<Index> rank;   ///< (n,) the place in postorder of every column of the pattern
  std::vector<Index> parent; ///< (n,) by rank: the first entry below the diagonal of a column; -1 at a root
  std::vector<Index> count;  ///< (n,) by rank: entries of every column, its diagonal included
};

/// Cost: O(entries α(n)).
EliminationTree eliminate(const OrderedPattern& pattern);

} // namespace dirichlet
