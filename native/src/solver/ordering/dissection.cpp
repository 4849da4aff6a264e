// SPDX-License-Identifier: GPL-3.0-or-later
#include "dissection.h"

#include <utility>

#include "arrangement.h"
#include "coarsening.h"
#include "leaf.h"
#include "lump.h"
#include "region_splitter.h"
#include "tree_refiner.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kTooSmall = 1000;                                 // a graph that minimum degree orders as well
constexpr Index kFinestPerCoarsest = 30;                          // vertices for one of the coarsest graph,
constexpr Index kSmallestCoarsest = 500, kLargestCoarsest = 7500; // as long as its size is within these bounds
constexpr Index kRegionWeight = 160, kRegionVertices = 20;        // what need not be divided in a coarse graph
constexpr Index kFinestRegion = kLargestLeaf / 8 * 7;             // nor in the graph itself; leaves room for changes

/// The graphs made of `graph`, each of the one before, until one is small or could not be made much smaller.
std::vector<CoarseGraph> coarsen(const Graph& graph, const CancelToken& cancel) {
  const Index enough = std::clamp(graph.size / kFinestPerCoarsest, kSmallestCoarsest, kLargestCoarsest);
  CoarseningScratch scratch;
  std::vector<CoarseGraph> levels;
  for (Index size = graph.size; size > enough; size = levels.back().size) {
    cancel.check();
    CoarseGraph coarse;
    if (levels.empty())
      coarsen(graph, scratch, coarse);
    else
      coarsen(levels.back().graph(), 0, scratch, coarse);
    if (coarse.size > size / 10 * 9) break;
    levels.push_back(std::move(coarse));
  }
  return levels;
}

class Dissection {
 public:
  Dissection(const Graph& graph, unsigned threads, const CancelToken& cancel)
      : graph_(graph), threads_(std::max(1U, threads)), cancel_(cancel) {}

  std::vector<Index> run() {
    std::vector<CoarseGraph> levels = coarsen(graph_, cancel_);
    notes_.fit(graph_.size);
    start_with_one_region(levels.empty() ? graph_.size : levels.back().size);
    for (; !levels.empty(); levels.pop_back()) {
      refine(levels.back().graph(), kRegionWeight, kRegionVertices);
      project(levels.back(), levels.size() == 1 ? graph_.size : levels[levels.size() - 2].size);
    }
    const RegionTree tree = refine(graph_, kFinestRegion, 0);
    cancel_.check();
    return arrange(graph_, tree, regions_, threads_);
  }

 private:
  void start_with_one_region(Index size) {
    regions_.fit(size);
    regions_.weight.assign(1, 0);
    for (Index v = 0; v < size; ++v) regions_.set(v, 0);
  }

  /// Divides regions that the graph is fine enough for, and refines all divisions.
  template <class G>
  RegionTree refine(const G& graph, Index region_weight, Index region_vertices) {
    splitter_.split(graph, region_weight, region_vertices, regions_);
    cancel_.check();
    RegionTree tree(regions_.depth);
    TreeRefiner(graph, tree, regions_, notes_).refine(threads_);
    return tree;
  }

  /// Carries the regions over from a coarse graph to the finer one it was made of.
  void project(const CoarseGraph& coarse, Index finer_size) {
    finer_.fit(finer_size);
    for (Index v = 0; v < finer_size; ++v) finer_.set(v, regions_[coarse.aggregate[v]]);
    finer_.weight = std::move(regions_.weight);
    finer_.depth = std::move(regions_.depth);
    std::swap(regions_, finer_);
  }

  Graph graph_;
  unsigned threads_;
  const CancelToken& cancel_;
  RegionSplitter splitter_{threads_};
  VertexNotes notes_;
  Regions regions_, finer_;
};

} // namespace

std::vector<Index> dissect(const Graph& graph, unsigned threads, const CancelToken& cancel) {
  return graph.size <= kTooSmall ? order_lump(graph) : Dissection(graph, threads, cancel).run();
}

} // namespace dirichlet::ordering
