// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "regions.h"
#include "vertex_notes.h"

namespace dirichlet::ordering {

/// Cuts graphs across few edges and improves cuts by moving vertices across, the best first, also for the worse for a
/// while (Fiduccia & Mattheyses 1982). Looks at nothing but the surroundings of the cut.
class CutRefiner {
 public:
  explicit CutRefiner(VertexNotes& notes)
      : notes_(notes), queue_{GainQueue(255, notes.links[0]), GainQueue(255, notes.links[0])} {}

  /// Takes vertices from region 1, where all of them are, to region 0, from `seed` on and always the one that cuts the
  /// fewest edges, until half the weight of a connected graph is there. Adds all ends of cut edges to `boundary`.
  void grow(const WeightedGraph& graph, Index seed, Regions& regions, VertexSet& boundary);

  /// Improves a cut until a pass over its boundary fails to. Who moves comes to some region of the other side. No side
  /// becomes heavier than 65 % unless it was.
  /// \param boundary holds at least all ends of cut edges; gets all vertices that were near the cut at some time.
  /// \returns the weight of the edges that are cut.
  template <class G>
  Index refine(const G& graph, const Division& division, Regions& regions, VertexSet& boundary);

 private:
  struct Move {
    Index vertex, from;
  };
  template <class G>
  class Pass;

  VertexNotes& notes_;
  std::array<GainQueue, 2> queue_; // of the vertices on each side that may cross
  std::vector<Move> moves_;        // in this pass
};

} // namespace dirichlet::ordering
