// SPDX-License-Identifier: GPL-3.0-or-later
#include "tree_refiner.h"

#include <bit>
#include <type_traits>

#include "workers.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kSmallestFork = 40; // regions worth a thread

} // namespace

template <class G>
TreeRefiner<G>::TreeRefiner(const G& graph, const RegionTree& tree, Regions& regions, VertexNotes& notes)
    : graph_(graph), tree_(tree), regions_(regions), notes_(notes), home_(static_cast<std::size_t>(graph.size)),
      nearby_(static_cast<std::size_t>(tree.size())) {
  for (Index v = 0; v < graph.size; ++v) home_[static_cast<std::size_t>(v)] = regions[v];
}

template <class G>
void TreeRefiner<G>::refine(unsigned threads) {
  if (tree_.root() == kNone) return;
  for (Index v = 0; v < graph_.size; ++v) hand_to(0, tree_.size() + 1, v);
  Workspace workspace(notes_);
  // Branches differ in size: eight for each thread even that out.
  const auto forks = threads > 1 ? static_cast<unsigned>(std::bit_width(threads)) + 2 : 0U;
  refine_from(tree_.root(), forks, workspace);
}

/// Lists v for the highest division that it is near to, among those of regions first … last - 1, its own among them.
template <class G>
void TreeRefiner<G>::hand_to(Index first, Index last, Index v) {
  Index low = regions_[v], high = low;
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
    const Index region = regions_[graph_.neighbours[e]];
    if (region < first || region >= last) continue;
    low = std::min(low, region);
    high = std::max(high, region);
  }
  if (low < high) nearby_[static_cast<std::size_t>(tree_.between(low, high))].push_back(v);
}

template <class G>
void TreeRefiner<G>::refine_from(Index k, unsigned forks, Workspace& workspace) {
  if (k == kNone) return;
  refine_one(k, workspace);
  const auto& node = tree_[k];
  if (forks == 0 || node.last - node.first < kSmallestFork) {
    refine_from(node.left, 0, workspace);
    refine_from(node.right, 0, workspace);
    return;
  }
  std::future<void> right = std::async(kAnyThread, [&] {
    Workspace own(notes_);
    refine_from(node.right, forks - 1, own);
  });
  refine_from(node.left, forks - 1, workspace);
  right.get();
}

template <class G>
void TreeRefiner<G>::refine_one(Index k, Workspace& workspace) {
  const Division division = tree_.division(k);
  VertexSet& boundary = workspace.boundary;
  for (const Index v : nearby_[static_cast<std::size_t>(k)])
    if (division.side(regions_[v]) <= kRight) boundary.add(v);
  workspace.cuts.refine(graph_, division, regions_, boundary);
  if constexpr (std::is_same_v<G, Graph>)
    workspace.separator.separate(graph_, division, RegionTree::separator(k), regions_, boundary);
  settle(division, workspace);
  for (const Index v : boundary.all()) {
    const Part side = division.side(regions_[v]);
    if (side == kLeft) hand_to(division.first, division.split, v);
    if (side == kRight) hand_to(division.split, division.last, v);
  }
  boundary.clear();
}

/// Those who are on their old side return to their old region. Those who changed sides join a region there, wave after
/// wave, beginning with those beside the old inhabitants: so the cuts of that side are carried on straight.
template <class G>
void TreeRefiner<G>::settle(const Division& division, Workspace& workspace) {
  auto& strangers = workspace.strangers;
  strangers.clear();
  for (const Index v : workspace.boundary.all()) {
    const Index region = regions_[v], home = home_[static_cast<std::size_t>(v)];
    if (region < 0) continue;
    if (division.side(region) == division.side(home)) {
      regions_.move(v, graph_.weight(v), home);
    } else {
      strangers.push_back(v);
      notes_.locked[v] = 1;
    }
  }
  for (workspace.wave = strangers; !workspace.wave.empty();) settle_wave(division, workspace);
  for (const Index v : strangers) { // also islands, where any region will do
    notes_.locked[v] = 0;
    home_[static_cast<std::size_t>(v)] = regions_[v];
  }
}

/// Settles those of a wave with a neighbour on their new side that is no stranger; the strangers beside them are the
/// next wave.
template <class G>
void TreeRefiner<G>::settle_wave(const Division& division, Workspace& workspace) {
  constexpr std::uint8_t kStranger = 1, kNext = 2;
  auto& wave = workspace.wave;
  auto& settled = workspace.settled;
  settled.clear();
  for (const Index v : wave)
    if (const Index region = nearest_region(division, v); region != kNone) settled.push_back({v, region});
  wave.clear();
  for (const auto& [v, region] : settled) {
    regions_.move(v, graph_.weight(v), region);
    notes_.locked[v] = 0;
  }
  for (const auto& [v, region] : settled)
    for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
      const Index u = graph_.neighbours[e];
      if (division.side(regions_[u]) != division.side(region) || notes_.locked[u] != kStranger) continue;
      notes_.locked[u] = kNext;
      wave.push_back(u);
    }
}

/// The region on v's side that v is tied to most, strangers not counted; kNone if there is none.
template <class G>
Index TreeRefiner<G>::nearest_region(const Division& division, Index v) const {
  std::array<Index, 8> region{}, weight{}; // of the regions met; so many hardly meet
  std::size_t met = 0;
  const Part side = division.side(regions_[v]);
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
    const Index u = graph_.neighbours[e], r = regions_[u];
    if (division.side(r) != side || notes_.locked[u] != 0) continue;
    std::size_t i = 0;
    while (i < met && region[i] != r) ++i;
    if (i == region.size()) continue;
    met = std::max(met, i + 1);
    region[i] = r;
    weight[i] += graph_.edge_weight(e);
  }
  if (met == 0) return kNone;
  return region[static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin())];
}

template class TreeRefiner<Graph>;
template class TreeRefiner<WeightedGraph>;

} // namespace dirichlet::ordering
