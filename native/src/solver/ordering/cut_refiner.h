// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "division.h"
#include "gain_queue.h"

namespace dirichlet::ordering {

/// Cuts graphs across few edges and improves cuts by moving vertices across, the best first, also for the worse for a
/// while (Fiduccia & Mattheyses 1982). Holds its arrays for the next graph.
class CutRefiner {
 public:
  /// Grows the left side from `seed`, always by the vertex that cuts the fewest edges, to half the weight of a
  /// connected graph.
  void grow(const CoarseGraph& graph, Index seed, Division& division);

  /// Improves a cut until a pass over its boundary fails to. Leaves exactly the boundary in division.boundary. No side
  /// becomes heavier than 65 % unless it was.
  void refine(const CoarseGraph& graph, Division& division);
  void refine(const Graph& graph, Division& division);

 private:
  template <class G>
  void refine_any(const G& graph, Division& division);
  template <class G>
  bool improve(const G& graph, Division& division);
  void enqueue(const Division& division, Index v, Index gain);
  template <class G>
  Index choose(const G& graph, const Division& division, Index heaviest);
  template <class G>
  void move(const G& graph, Index v, Division& division);
  void fit(Index size);
  void begin_pass();
  void end_pass(std::size_t kept, Division& division);

  std::array<GainQueue, 2> queue_{GainQueue(255), GainQueue(255)}; // of the vertices on each side that may cross
  Scratch<Index> gain_;                                            // of every vertex in a queue
  Scratch<std::uint8_t> locked_;                                   // vertices not to move (again) in this pass
  std::vector<Index> moved_, touched_;                             // in this pass; touched: were in a queue
};

} // namespace dirichlet::ordering
