// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bisection.h"
#include "regions.h"

namespace dirichlet::ordering {

/// Halves the regions of a graph, and their halves, until none is large. Holds its arrays for the next graph.
class RegionSplitter {
 public:
  explicit RegionSplitter(unsigned threads) : tools_(threads) {}

  /// A region is large that weighs more than `weight` and has more than `vertices`; lumps that nothing divides stay
  /// large. Regions without vertices are removed. Sets the regions' weights.
  template <class G>
  void split(const G& graph, Index weight, Index vertices, Regions& regions);

 private:
  /// What a thread needs to halve one region after the other.
  struct Tools {
    Bisection bisection;
    Scratch<Index> offsets, neighbours, weights, edge_weights;
  };

  template <class G>
  void count(const G& graph, Regions& regions);
  void choose_large(Index weight, Index vertices, const Regions& regions);
  template <class G>
  void halve_large(const G& graph, const Regions& regions);
  template <class G>
  WeightedGraph extract(const G& graph, const Regions& regions, std::span<const Index> vertices, Tools& tools);
  void renumber(Index vertex_count, Regions& regions);

  std::vector<Tools> tools_;
  std::vector<Index> size_;                  // vertices of each region
  std::vector<std::uint8_t> is_new_, parts_; // of each region: whether it was halved into being; what became of it
  std::vector<Index> large_, begin_;         // large regions, and where their lists of vertices begin in
  std::vector<Index> vertices_;              // the vertices of large regions
  Scratch<Index> number_;                    // of a vertex within its region
  Scratch<std::uint8_t> half_;               // of its region that a vertex is in
};

} // namespace dirichlet::ordering
