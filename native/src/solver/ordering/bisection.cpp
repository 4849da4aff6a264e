// SPDX-License-Identifier: GPL-3.0-or-later
#include "bisection.h"

#include <numeric>
#include <utility>

#include "coarsening.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = -1;
constexpr Index kCoarsest = 60;
constexpr std::size_t kMaxLevels = 40;

Index heaviest_side(Index total) {
  return total / 2 + total / 20;
}

} // namespace

const std::uint8_t* Bisection::halve(const Graph& graph) {
  const int coarsest = build_levels(graph);
  const auto level = [&](int l) -> CoarseGraph& { return levels_[static_cast<std::size_t>(l)]; };
  const bool connected = !part_components(level(coarsest));
  const Index heaviest = heaviest_side(graph.size);
  if (connected) cut_coarsest(level(coarsest), std::clamp(graph.size / 500, 2, 8), heaviest);
  for (int l = coarsest; l >= 0; --l) {
    const CoarseGraph& coarse = level(l);
    const Index finer_size = l > 0 ? level(l - 1).size : graph.size;
    std::uint8_t* finer = finer_side_.fit(finer_size);
    for (Index v = 0; v < finer_size; ++v) finer[v] = side_[coarse.aggregate[v]];
    std::swap(side_, finer_side_);
    if (connected && l > 0) refiner_.refine(level(l - 1), heaviest, side_.data(), cut_);
  }
  return side_.data();
}

/// \returns the coarsest level: small, or one that could not be made much smaller.
int Bisection::build_levels(const Graph& graph) {
  if (levels_.empty()) levels_.resize(kMaxLevels);
  coarsen(graph, scratch_, levels_[0]);
  std::size_t l = 0;
  while (levels_[l].size > kCoarsest && l + 1 < kMaxLevels) {
    coarsen(levels_[l], scratch_, levels_[l + 1]);
    if (levels_[l + 1].size > levels_[l].size / 10 * 9) break;
    ++l;
  }
  return static_cast<int>(l);
}

/// If the graph is not connected, puts its components one by one, in the order of their first vertices, on the lighter
/// side. A component heavier than all others ends up nearly alone, so this halves what is left, too.
bool Bisection::part_components(const CoarseGraph& graph) {
  std::uint8_t* side = side_.fit(graph.size);
  constexpr std::uint8_t kUnseen = 2;
  std::fill_n(side, graph.size, kUnseen);
  Index load[2] = {0, 0};
  int components = 0;
  for (Index start = 0; start < graph.size; ++start) {
    if (side[start] != kUnseen) continue;
    ++components;
    const std::uint8_t to = load[1] < load[0] ? 1 : 0;
    queue_.assign(1, start);
    side[start] = to;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const Index v = queue_[head];
      load[to] += graph.weight(v);
      for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
        if (std::uint8_t& other = side[graph.neighbours[e]]; other == kUnseen) {
          other = to;
          queue_.push_back(graph.neighbours[e]);
        }
    }
  }
  return components > 1;
}

/// Grows from several seeds, the first of them at the rim, and keeps the best cut.
void Bisection::cut_coarsest(const CoarseGraph& graph, Index tries, Index heaviest) {
  std::uint8_t* trial = trial_.fit(graph.size);
  cut_ = {{0, 0}, kNone};
  for (Index t = 0; t < tries; ++t) {
    const Index seed = t == 0 ? farthest(graph, farthest(graph, 0)) : graph.size / tries * t;
    Cut cut = refiner_.grow(graph, seed, trial);
    refiner_.refine(graph, heaviest, trial, cut);
    if (cut_.edges != kNone && cut.edges >= cut_.edges) continue;
    cut_ = cut;
    std::copy_n(trial, graph.size, side_.data());
  }
}

/// The last vertex that a breadth-first search reaches.
Index Bisection::farthest(const CoarseGraph& graph, Index start) {
  Index* seen = scratch_.fit(graph.size);
  std::fill_n(seen, graph.size, 0);
  queue_.assign(1, start);
  seen[start] = 1;
  for (std::size_t head = 0; head < queue_.size(); ++head)
    for (Index e = graph.offsets[queue_[head]]; e < graph.offsets[queue_[head] + 1]; ++e)
      if (Index& other = seen[graph.neighbours[e]]; other == 0) {
        other = 1;
        queue_.push_back(graph.neighbours[e]);
      }
  return queue_.back();
}

} // namespace dirichlet::ordering
