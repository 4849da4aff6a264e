// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "cut_refiner.h"

namespace dirichlet::ordering {

/// Halves graphs across few edges: coarsens, cuts the coarsest graph, and refines the cut on the way back (Hendrickson
/// & Leland 1995; Karypis & Kumar 1998). Holds its arrays for the next graph.
class Bisection {
 public:
  /// \returns the side, 0 or 1, of every vertex of `graph`, until the next call. Where the graph is not connected, the
  /// sides are whole components. One side may stay empty: of a single vertex, or of a lump that nothing divides.
  const std::uint8_t* halve(const Graph& graph);

 private:
  int build_levels(const Graph& graph);
  bool part_components(const CoarseGraph& graph);
  void cut_coarsest(const CoarseGraph& graph, Index tries, Index heaviest);
  Index farthest(const CoarseGraph& graph, Index start);

  std::vector<CoarseGraph> levels_;
  CutRefiner refiner_;
  Cut cut_;
  Scratch<std::uint8_t> side_, finer_side_, trial_;
  Scratch<Index> scratch_;
  std::vector<Index> queue_;
};

} // namespace dirichlet::ordering
