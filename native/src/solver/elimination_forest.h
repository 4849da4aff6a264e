// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/ordered_matrix.h"

namespace dirichlet {

/// The structure of the factor of a matrix, exactly: columns whose structure is that of the column before without it
/// make one supernode. Supernodes are in postorder: every subtree is one run that ends with its root.
struct EliminationForest {
  std::vector<Index> owner;            ///< (n,) the supernode of every column of the pattern
  std::vector<Index> parent;           ///< (S,) the owner of the first row; -1 at a root
  std::vector<Index> width;            ///< (S,) columns
  std::vector<Index> row_count;        ///< (S,) rows below them
  std::vector<std::int64_t> row_begin; ///< (S,) where they are in `rows`
  std::vector<Index> rows;             ///< columns of the pattern, ascending in each supernode

  [[nodiscard]] Index size() const { return static_cast<Index>(parent.size()); }
  [[nodiscard]] std::span<const Index> rows_of(Index s) const {
    return {rows.data() + row_begin[at(s)], at(row_count[at(s)])};
  }
};

/// Cost: O(entries + rows of supernodes), and O(entries of the factor) at worst.
EliminationForest eliminate(const OrderedPattern& pattern);

} // namespace dirichlet
