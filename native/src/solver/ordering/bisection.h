// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut_refiner.h"

namespace dirichlet::ordering {

/// Halves graphs across few edges: coarsens, cuts the coarsest graph, and refines the cut on the way back (Hendrickson
/// & Leland 1995; Karypis & Kumar 1998). Holds its arrays for the next graph.
class Bisection {
 public:
  /// \returns two sides of `graph`, until the next call. Where the graph is not connected, the sides are whole
  /// components. One side may stay empty: of a single vertex, or of a lump that nothing divides.
  Division& halve(const Graph& graph);

 private:
  std::size_t coarsen_from(std::size_t level, Index size, Index variant);
  bool part_components(const CoarseGraph& graph);
  void cut_best_of(Index runs, std::size_t level, Index seeds);
  void cut_coarsest(const CoarseGraph& graph, Index seeds);
  void project(const CoarseGraph& coarse, Index finer_size);
  Index farthest(const CoarseGraph& graph, Index start);

  std::vector<CoarseGraph> levels_; // the first made of the graph, each of the next of the one before
  CutRefiner refiner_;
  Division now_, best_, trial_, best_trial_;
  Scratch<std::uint8_t> finer_part_;
  std::vector<Index> finer_boundary_;
  Scratch<Index> scratch_;
  std::vector<Index> queue_;
};

} // namespace dirichlet::ordering
