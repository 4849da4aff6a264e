// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dirichlet/array.h"
#include "index.h"

namespace dirichlet {

/// A graph in compressed rows: vertex v has neighbours[offsets[v]] … neighbours[offsets[v + 1]). Symmetric; a vertex
/// listed as its own neighbour is passed over.
struct Graph {
  std::span<const Index> offsets; ///< (n + 1,)
  std::span<const Index> neighbours;
  [[nodiscard]] Index size() const { return static_cast<Index>(offsets.size()) - 1; }
};

/// All that a Cholesky factorisation knows before it sees a number. It depends on the mesh alone: painted vertices stay
/// in the system as identity rows, so it survives every painting.
///
/// Columns are *positions* in the order of elimination. Neighbouring columns with (almost) the same structure form a
/// *supernode*: w columns, r rows below them, stored as one dense panel of w + r rows. Supernodes form a forest; a
/// child is numbered before its parent, and the descendants of a supernode stand right before it unless it is shared.
struct SymbolicFactor {
  std::vector<Index> order;                ///< (n,) the vertex at every position
  std::vector<Index> columns;              ///< (S + 1,) supernode s has the columns columns[s] … columns[s + 1)
  std::vector<Index> owner;                ///< (n,) the supernode of every column
  std::vector<Index> parent;               ///< (S,) or -1 at a root
  std::vector<std::int64_t> row_offsets;   ///< (S + 1,)
  std::vector<Index> rows;                 ///< positions of the rows below each supernode's columns, ascending
  std::vector<std::int64_t> panel_offsets; ///< (S + 1,) where panels start in the factor's storage

  /// Two halves of about equal work that do not touch each other, [group[0], group[1]) and [group[1], group[2]) of the
  /// supernodes, and what they share: the separators at the top, [group[2], S).
  std::array<Index, 3> group{};

  [[nodiscard]] Index size() const { return static_cast<Index>(order.size()); }
  [[nodiscard]] Index supernode_count() const { return static_cast<Index>(parent.size()); }
  [[nodiscard]] Index width(Index s) const { return columns[at(s) + 1] - columns[at(s)]; }
  [[nodiscard]] Index row_count(Index s) const {
    return static_cast<Index>(row_offsets[at(s) + 1] - row_offsets[at(s)]);
  }
  [[nodiscard]] std::span<const Index> rows_of(Index s) const {
    return {rows.data() + row_offsets[at(s)], static_cast<std::size_t>(row_count(s))};
  }
  [[nodiscard]] std::int64_t factor_size() const { return panel_offsets.back(); } ///< numbers in all panels
};

/// Analyses a symmetric pattern in the given order of elimination (a permutation of its vertices), which is refined to
/// one that keeps the descendants of every supernode together at the same fill.
///
/// Symbolic elimination by supernodes (George & Liu 1980), which are then relaxed (Ashcraft & Grimes 1989). Cost, for a
/// mesh: O(entries + rows of supernodes) time and memory.
SymbolicFactor analyse(const Graph& graph, std::span<const Index> elimination_order);

} // namespace dirichlet
