// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cut_refiner.h"
#include "region_tree.h"
#include "separator.h"

namespace dirichlet::ordering {

/// Refines all divisions of a dissected graph, from the root of their tree down. Visits only what is near a cut, and
/// every vertex there for the highest division it is near to; from there it is handed down.
template <class G>
class TreeRefiner {
 public:
  /// \param notes room for the graph's vertices.
  TreeRefiner(const G& graph, const RegionTree& tree, Regions& regions, VertexNotes& notes);

  /// Refines cuts; of a Graph, which has no finer one, also makes the separators. Uses at most about `threads` threads.
  void refine(unsigned threads);

 private:
  struct Workspace {
    explicit Workspace(VertexNotes& notes) : cuts(notes), separator(notes), boundary(notes) {}
    CutRefiner cuts;
    Separator separator;
    VertexSet boundary;
    std::vector<Index> strangers, wave;
    std::vector<std::array<Index, 2>> settled;
  };

  void hand_to(Index first, Index last, Index v);
  void refine_from(Index k, unsigned forks, Workspace& workspace);
  void refine_one(Index k, Workspace& workspace);
  void settle(const Division& division, Workspace& workspace);
  void settle_wave(const Division& division, Workspace& workspace);
  [[nodiscard]] Index nearest_region(const Division& division, Index v) const;

  const G& graph_;
  const RegionTree& tree_;
  Regions& regions_;
  VertexNotes& notes_;
  std::vector<Index> home_;                // the region of each vertex when the division under way was not yet refined
  std::vector<std::vector<Index>> nearby_; // vertices near to each division; some may have moved elsewhere since
};

} // namespace dirichlet::ordering
