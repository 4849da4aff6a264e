// SPDX-License-Identifier: GPL-3.0-or-later
#include "bisection.h"

#include <numeric>
#include <utility>

namespace dirichlet::ordering {
namespace {

constexpr Index kCoarsest = 60;
constexpr std::size_t kMaxLevels = 40;
constexpr Division kHalves{0, 1, 2};

} // namespace

const Regions& Bisection::halve(const WeightedGraph& graph) {
  if (levels_.empty()) levels_.resize(kMaxLevels);
  graph_ = graph;
  notes_.fit(graph.size);
  // What weighs much is worth several cuts; what these share is the way down to a fifth of the graph.
  const Index weight = std::accumulate(graph.weights, graph.weights + graph.size, Index{0});
  const Index runs = std::clamp(weight / 2000, 1, 5);
  const Index seeds = graph.size <= kCoarsest ? 1 : std::clamp(weight / 4000, 2, 4);
  const std::size_t shared = coarsen_from(0, std::max(kCoarsest, graph.size / 5), 0);
  const WeightedGraph coarse = this->graph(shared);
  search_anew(coarse, 0);
  if (found_.size() == static_cast<std::size_t>(coarse.size))
    cut_best_of(runs, shared, seeds);
  else
    part_components(coarse);
  for (std::size_t l = shared; l > 0; --l) project(l);
  return now_.regions;
}

/// Coarsens from `level` on to a graph of `size`, or to one that could not be made much smaller. \returns its level.
std::size_t Bisection::coarsen_from(std::size_t level, Index size, Index variant) {
  while (graph(level).size > size && level + 1 < kMaxLevels) {
    coarsen(graph(level), variant, scratch_, levels_[level + 1]);
    if (levels_[level + 1].size > graph(level).size / 10 * 9) break;
    ++level;
  }
  return level;
}

/// Searches breadth first, past vertices that were found before.
void Bisection::search(const WeightedGraph& graph, Index start) {
  auto& found_before = notes_.locked;
  const auto visit = [&](Index v) {
    if (found_before[v] != 0) return;
    found_before[v] = 1;
    found_.push_back(v);
  };
  found_.clear();
  visit(start);
  for (std::size_t head = 0; head < found_.size(); ++head) { // NOLINT(modernize-loop-convert): found_ grows
    const Index v = found_[head];
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) visit(graph.neighbours[e]);
  }
}

void Bisection::search_anew(const WeightedGraph& graph, Index start) {
  search(graph, start);
  for (const Index v : found_) notes_.locked[v] = 0;
}

/// Puts the components one by one, in the order of their first vertices, on the lighter side: it may take several
/// divisions until they are apart, but these cost no separator.
void Bisection::part_components(const WeightedGraph& graph) {
  auto& weight = now_.regions.weight;
  now_.regions.fit(graph.size);
  weight.assign(2, 0);
  for (Index start = 0; start < graph.size; ++start) {
    if (notes_.locked[start] != 0) continue;
    search(graph, start);
    const Index side = weight[1] < weight[0] ? 1 : 0;
    for (const Index v : found_) {
      now_.regions.set(v, side);
      weight[static_cast<std::size_t>(side)] += graph.weight(v);
    }
  }
  std::fill_n(notes_.locked.data(), graph.size, std::uint8_t{0});
}

/// Coarsens and cuts the graph of a level several times, each time in another way, and keeps the best.
void Bisection::cut_best_of(Index runs, std::size_t level, Index seeds) {
  for (Index run = 0; run < runs; ++run) {
    const std::size_t coarsest = coarsen_from(level, kCoarsest, run);
    cut_coarsest(graph(coarsest), seeds);
    for (std::size_t l = coarsest; l > level; --l) project(l);
    if (run == 0 || now_.score() < best_.score()) std::swap(now_, best_);
  }
  std::swap(now_, best_);
}

/// Grows from several seeds, the first of them at the rim, and keeps the best cut.
void Bisection::cut_coarsest(const WeightedGraph& graph, Index seeds) {
  search_anew(graph, 0);
  search_anew(graph, found_.back());
  const Index rim = found_.back();
  for (Index k = 0; k < seeds; ++k) {
    cut_from(graph, k == 0 ? rim : graph.size / seeds * k);
    if (seeds > 1) trial_.between = refiner_.refine(graph, kHalves, trial_.regions, boundary_);
    boundary_.clear();
    if (k == 0 || trial_.score() < best_trial_.score()) std::swap(trial_, best_trial_);
  }
  std::swap(now_, best_trial_);
}

void Bisection::cut_from(const WeightedGraph& graph, Index seed) {
  Regions& regions = trial_.regions;
  regions.fit(graph.size);
  regions.weight.assign(2, 0);
  for (Index v = 0; v < graph.size; ++v) {
    regions.set(v, 1);
    regions.weight[1] += graph.weight(v);
  }
  refiner_.grow(graph, seed, regions, boundary_);
}

/// Carries now_ over from a level to the finer one it was made of, and refines it there.
void Bisection::project(std::size_t level) {
  const CoarseGraph& coarse = levels_[level];
  const WeightedGraph finer = graph(level - 1);
  finer_.fit(finer.size);
  finer_.weight = now_.regions.weight;
  for (Index v = 0; v < finer.size; ++v) finer_.set(v, now_.regions[coarse.aggregate[v]]);
  std::swap(now_.regions, finer_);
  const Regions& regions = now_.regions;
  for (Index v = 0; v < finer.size; ++v)
    if (std::any_of(finer.neighbours + finer.offsets[v], finer.neighbours + finer.offsets[v + 1],
                    [&, own = regions[v]](Index u) { return regions[u] != own; }))
      boundary_.add(v);
  now_.between = refiner_.refine(finer, kHalves, now_.regions, boundary_);
  boundary_.clear();
}

} // namespace dirichlet::ordering
