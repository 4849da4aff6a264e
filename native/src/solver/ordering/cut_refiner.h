// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gain_queue.h"

namespace dirichlet::ordering {

/// Two sides of a weighted graph, and the weight of the edges between them.
struct Cut {
  std::array<Index, 2> weight{};
  Index edges = 0;
};

/// Makes cuts of weighted graphs and improves them by moving vertices across, the best first, also for the worse for a
/// while (Fiduccia & Mattheyses 1982). Holds its arrays for the next graph.
class CutRefiner {
 public:
  /// Grows side 0 from `seed`, always by the vertex that cuts the fewest edges, to half the weight.
  /// \param side (size,) is written. The graph must be connected.
  Cut grow(const CoarseGraph& graph, Index seed, std::uint8_t* side);

  /// Improves a cut until a pass over it fails to. Neither side shall weigh more than `heaviest`, if that can be had.
  void refine(const CoarseGraph& graph, Index heaviest, std::uint8_t* side, Cut& cut);

 private:
  struct Quality;
  Quality quality(const Cut& cut) const;
  void fit(const CoarseGraph& graph);
  void enqueue(const CoarseGraph& graph, const std::uint8_t* side, Index v);
  Index choose(const CoarseGraph& graph, const Cut& cut);
  void move(const CoarseGraph& graph, Index v, std::uint8_t* side, Cut& cut);
  bool improve(const CoarseGraph& graph, std::uint8_t* side, Cut& cut);

  Index heaviest_ = 0;
  std::array<GainQueue, 2> queue_{GainQueue(255), GainQueue(255)}; // of the vertices on each side that may cross
  Scratch<Index> gain_;                                            // of every vertex that was in a queue this pass
  Scratch<std::uint8_t> locked_;
  std::vector<Index> moved_;
  std::vector<Index> boundary_, touched_;
};

} // namespace dirichlet::ordering
