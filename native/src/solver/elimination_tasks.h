// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/symbolic.h"

namespace dirichlet {

/// Numbers in the lower triangle of an update matrix of r rows, stored in blocks of columns: block b holds the columns
/// from b kBlock on, each from its block's first row down, so that little above the diagonal is stored.
struct UpdateLayout {
  static constexpr Index kBlock = 64;

  /// Where column j has its row 0, which is not stored itself unless j < kBlock; rows of a column are consecutive.
  static std::int64_t column(Index r, Index j) {
    const std::int64_t block = j / kBlock, first = block * kBlock;
    return kBlock * (block * r - kBlock * block * (block - 1) / 2) + (j - first) * (r - first) - first;
  }
  /// Where the block that begins with column j starts.
  static std::int64_t block(Index r, Index j) { return column(r, j) + j; }
  static std::int64_t size(Index r) {
    const Index first = r / kBlock * kBlock;
    return block(r, first) + std::int64_t{r - first} * (r - first);
  }
};

/// The forest of supernodes cut into pieces that are factored, kept and repeated as one: many small subtrees, and above
/// them every supernode alone. What a piece passes on to its parent, the update matrix of its last supernode, is kept;
/// so when paint changes, only pieces on the way from the change to the root are factored again.
struct EliminationTasks {
  struct Task {
    Index first, last;   ///< supernodes, last included
    Index parent;        ///< or -1
    std::int64_t update; ///< where its update matrix is kept
  };
  std::vector<Task> tasks;     ///< children before parents
  std::vector<Index> owner;    ///< (S,) the task of every supernode
  Index shared = 0;            ///< tasks from here on are the separators that both halves share
  std::int64_t kept_size = 0;  ///< numbers in all kept update matrices
  std::int64_t stack_size = 0; ///< numbers that the update matrices inside one subtree take at the same time
};

/// Subtrees as small as the budget allows: the smaller they are, the less work is repeated, and the more is kept.
/// \param most_kept  numbers that kept update matrices may have; a forest may need more even when cut as little as can
/// be. Cost: O(S) for each of a few tries.
EliminationTasks cut_into_tasks(const SymbolicFactor& symbolic, std::int64_t most_kept);

} // namespace dirichlet
