// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "regions.h"
#include "vertex_notes.h"

namespace dirichlet::ordering {

/// Turns a cut through edges into a set of vertices without which no edge joins left and right, and makes that set
/// small by moving its vertices to either side, their neighbours on the other side taking their place (Ashcraft & Liu
/// 1995; Hendrickson & Rothberg 1998).
class Separator {
 public:
  explicit Separator(VertexNotes& notes)
      : notes_(notes), queue_{GainQueue(31, notes.links[0]), GainQueue(31, notes.links[1])} {}

  /// Puts the separator of a division in region `name`, which is below Division::kUndecided. Who changes sides comes to
  /// some region there.
  /// \param boundary holds at least all ends of cut edges; gets all vertices that were near the cut at some time.
  void separate(const Graph& graph, const Division& division, Index name, Regions& regions, VertexSet& boundary);

 private:
  class Search;
  struct Change {
    Index vertex, before; ///< the region it was in
  };

  VertexNotes& notes_;
  std::array<GainQueue, 2> queue_;         // separator vertices, by the side they may move to
  std::vector<Change> changes_;            // in this pass
  std::vector<Index> separator_, touched_; // touched: were in the separator in this pass
  std::array<std::vector<Index>, 2> ends_; // of cut edges
};

} // namespace dirichlet::ordering
