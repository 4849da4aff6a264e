// SPDX-License-Identifier: GPL-3.0-or-later
#include "bisection.h"

#include <utility>

#include "coarsening.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kCoarsest = 60;
constexpr std::size_t kMaxLevels = 40;

} // namespace

Division& Bisection::halve(const Graph& graph) {
  if (levels_.empty()) levels_.resize(kMaxLevels);
  coarsen(graph, scratch_, levels_[0]);
  // Large graphs are worth several cuts; what these share is the way down to a fifth of the first coarse graph.
  const std::size_t shared = coarsen_from(0, std::max(kCoarsest, levels_[0].size / 5), 0);
  if (!part_components(levels_[shared]))
    cut_best_of(std::clamp(graph.size / 2000, 1, 10), shared, std::clamp(graph.size / 4000, 2, 8));
  for (std::size_t l = shared; l > 0; --l) {
    project(levels_[l], levels_[l - 1].size);
    refiner_.refine(levels_[l - 1], now_);
  }
  project(levels_[0], graph.size);
  refiner_.refine(graph, now_);
  return now_;
}

/// Coarsens from `level` on to a graph of `size`, or to one that could not be made much smaller. \returns its level.
std::size_t Bisection::coarsen_from(std::size_t level, Index size, Index variant) {
  while (levels_[level].size > size && level + 1 < kMaxLevels) {
    coarsen(levels_[level], variant, scratch_, levels_[level + 1]);
    if (levels_[level + 1].size > levels_[level].size / 10 * 9) break;
    ++level;
  }
  return level;
}

/// If the graph is not connected, puts its components one by one, in the order of their first vertices, on the lighter
/// side: it may take several divisions until they are apart, but these cost no separator.
bool Bisection::part_components(const CoarseGraph& graph) {
  constexpr std::uint8_t kUnseen = kSeparator;
  std::uint8_t* part = now_.part.fit(graph.size);
  std::fill_n(part, graph.size, kUnseen);
  now_.weight = {};
  now_.cut = 0;
  now_.boundary.clear();
  int components = 0;
  for (Index start = 0; start < graph.size; ++start) {
    if (part[start] != kUnseen) continue;
    ++components;
    const Part side = now_.weight[kRight] < now_.weight[kLeft] ? kRight : kLeft;
    queue_.assign(1, start);
    part[start] = side;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const Index v = queue_[head];
      now_.weight[side] += graph.weight(v);
      for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
        if (const Index u = graph.neighbours[e]; part[u] == kUnseen) {
          part[u] = side;
          queue_.push_back(u);
        }
    }
  }
  return components > 1;
}

/// Coarsens and cuts the graph of a level several times, each time in another way, and keeps the best.
void Bisection::cut_best_of(Index runs, std::size_t level, Index seeds) {
  for (Index run = 0; run < runs; ++run) {
    const std::size_t coarsest = coarsen_from(level, kCoarsest, run);
    cut_coarsest(levels_[coarsest], seeds);
    for (std::size_t l = coarsest; l > level; --l) {
      project(levels_[l], levels_[l - 1].size);
      refiner_.refine(levels_[l - 1], now_);
    }
    if (run == 0 || now_.score() < best_.score()) std::swap(now_, best_);
  }
  std::swap(now_, best_);
}

/// Grows from several seeds, the first of them at the rim, and keeps the best cut.
void Bisection::cut_coarsest(const CoarseGraph& graph, Index seeds) {
  for (Index k = 0; k < seeds; ++k) {
    refiner_.grow(graph, k == 0 ? farthest(graph, farthest(graph, 0)) : graph.size / seeds * k, trial_);
    refiner_.refine(graph, trial_);
    if (k == 0 || trial_.score() < best_trial_.score()) std::swap(trial_, best_trial_);
  }
  std::swap(now_, best_trial_);
}

/// Carries now_ over from a coarse graph to the finer one it was made of.
void Bisection::project(const CoarseGraph& coarse, Index finer_size) {
  std::uint8_t* finer = finer_part_.fit(finer_size);
  for (Index v = 0; v < finer_size; ++v) finer[v] = now_.part[coarse.aggregate[v]];
  std::swap(now_.part, finer_part_);
  finer_boundary_.clear();
  for (const Index v : now_.boundary)
    for (Index m = coarse.member_offsets[v]; m < coarse.member_offsets[v + 1]; ++m)
      finer_boundary_.push_back(coarse.members[m]);
  std::swap(now_.boundary, finer_boundary_);
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
