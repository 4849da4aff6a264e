// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "coarsening.h"
#include "cut_refiner.h"

namespace dirichlet::ordering {

/// Halves graphs across few edges: coarsens, cuts the coarsest graph, and refines the cut on the way back (Hendrickson
/// & Leland 1995; Karypis & Kumar 1998). Holds its arrays for the next graph.
class Bisection {
 public:
  /// \returns regions 0 and 1 of `graph`, until the next call; of a small graph roughly. Where the graph is not
  /// connected, the regions are whole components. One may stay empty: of a single vertex, or of a lump that nothing
  /// divides.
  const Regions& halve(const WeightedGraph& graph);

 private:
  struct Cut {
    Regions regions;
    Index between = 0; ///< weight of the edges between the regions
    [[nodiscard]] double score() const { return division_score(between, regions.weight[0], regions.weight[1]); }
  };

  [[nodiscard]] WeightedGraph graph(std::size_t level) const { return level == 0 ? graph_ : levels_[level].graph(); }
  std::size_t coarsen_from(std::size_t level, Index size, Index variant);
  void search(const WeightedGraph& graph, Index start);
  void search_anew(const WeightedGraph& graph, Index start);
  void part_components(const WeightedGraph& graph);
  void cut_best_of(Index runs, std::size_t level, Index seeds);
  void cut_coarsest(const WeightedGraph& graph, Index seeds);
  void cut_from(const WeightedGraph& graph, Index seed);
  void project(std::size_t level);

  WeightedGraph graph_;
  std::vector<CoarseGraph> levels_; // each but the first made of the level before
  VertexNotes notes_;
  CutRefiner refiner_{notes_};
  VertexSet boundary_{notes_};
  Cut now_, best_, trial_, best_trial_;
  Regions finer_;
  CoarseningScratch scratch_;
  std::vector<Index> found_; // by a search, in this order
};

} // namespace dirichlet::ordering
