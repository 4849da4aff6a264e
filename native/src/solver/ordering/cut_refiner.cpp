// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_refiner.h"

#include <tuple>

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = GainQueue::kNone;
constexpr std::size_t kPatience = 50; // moves in vain before a pass gives up
constexpr int kPasses = 6;

struct Degrees {
  Index across = 0, inside = 0;
};

Degrees degrees(const CoarseGraph& graph, const std::uint8_t* side, Index v) {
  Degrees d;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    (side[graph.neighbours[e]] == side[v] ? d.inside : d.across) += graph.edge_weight(e);
  return d;
}

} // namespace

/// Less is better.
struct CutRefiner::Quality {
  Index overweight, edges, difference;
  bool operator<(const Quality& o) const {
    return std::tie(overweight, edges, difference) < std::tie(o.overweight, o.edges, o.difference);
  }
};

CutRefiner::Quality CutRefiner::quality(const Cut& cut) const {
  const auto [lighter, heavier] = std::minmax(cut.weight[0], cut.weight[1]);
  return {std::max(0, heavier - heaviest_), cut.edges, heavier - lighter};
}

void CutRefiner::fit(const CoarseGraph& graph) {
  for (GainQueue& queue : queue_) queue.fit(graph.size);
  gain_.fit(graph.size);
  locked_.fit_filled(graph.size, 0);
}

Cut CutRefiner::grow(const CoarseGraph& graph, Index seed, std::uint8_t* side) {
  fit(graph);
  std::fill_n(side, graph.size, std::uint8_t{1});
  Cut cut;
  for (Index v = 0; v < graph.size; ++v) cut.weight[1] += graph.weight(v);
  enqueue(graph, side, seed);
  for (Index v = seed; v != kNone && cut.weight[0] < cut.weight[1]; v = queue_[1].top()) move(graph, v, side, cut);
  for (GainQueue& queue : queue_) queue.clear();
  for (const Index v : moved_) locked_[v] = 0;
  moved_.clear();
  touched_.clear();
  return cut;
}

void CutRefiner::refine(const CoarseGraph& graph, Index heaviest, std::uint8_t* side, Cut& cut) {
  fit(graph);
  heaviest_ = heaviest;
  boundary_.clear();
  for (Index v = 0; v < graph.size; ++v) {
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (side[graph.neighbours[e]] != side[v]) {
        boundary_.push_back(v);
        break;
      }
  }
  for (int pass = 0; pass < kPasses && improve(graph, side, cut); ++pass) {
  }
}

void CutRefiner::enqueue(const CoarseGraph& graph, const std::uint8_t* side, Index v) {
  const Degrees d = degrees(graph, side, v);
  gain_[v] = d.across - d.inside;
  queue_[side[v]].insert(v, gain_[v]);
  touched_.push_back(v);
}

/// The best vertex to move that does not overload a side, taken from the heavier side when in doubt.
Index CutRefiner::choose(const CoarseGraph& graph, const Cut& cut) {
  while (true) {
    const Index a = queue_[0].top(), b = queue_[1].top();
    if (a == kNone && b == kNone) return kNone;
    const int heavier = cut.weight[1] > cut.weight[0] ? 1 : 0;
    int from = heavier;
    if (a == kNone || b == kNone)
      from = a == kNone ? 1 : 0;
    else if (cut.weight[static_cast<std::size_t>(heavier)] <= heaviest_ && gain_[a] != gain_[b])
      from = gain_[b] > gain_[a] ? 1 : 0;
    const Index v = from == 0 ? a : b;
    if (from == heavier || cut.weight[static_cast<std::size_t>(heavier)] + graph.weight(v) <= heaviest_) return v;
    queue_[static_cast<std::size_t>(from)].remove(v);
  }
}

void CutRefiner::move(const CoarseGraph& graph, Index v, std::uint8_t* side, Cut& cut) {
  const std::uint8_t from = side[v], to = from ^ 1U;
  queue_[from].remove(v);
  locked_[v] = 1;
  moved_.push_back(v);
  side[v] = to;
  cut.weight[from] -= graph.weight(v);
  cut.weight[to] += graph.weight(v);
  cut.edges -= gain_[v];
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
    const Index u = graph.neighbours[e];
    if (locked_[u] != 0) continue;
    GainQueue& queue = queue_[side[u]];
    if (!queue.contains(u)) {
      if (side[u] == from) enqueue(graph, side, u);
      continue;
    }
    gain_[u] += (side[u] == from ? 2 : -2) * graph.edge_weight(e);
    queue.update(u, gain_[u]);
  }
}

/// One pass: every vertex moves at most once, then what came after the best state is taken back.
bool CutRefiner::improve(const CoarseGraph& graph, std::uint8_t* side, Cut& cut) {
  for (const Index v : boundary_)
    if (!queue_[side[v]].contains(v)) enqueue(graph, side, v);
  const Quality start = quality(cut);
  Quality best = start;
  Cut best_cut = cut;
  std::size_t kept = 0;
  const std::size_t patience = kPatience + boundary_.size() / 4;
  while (moved_.size() < kept + patience) {
    const Index v = choose(graph, cut);
    if (v == kNone) break;
    move(graph, v, side, cut);
    if (const Quality now = quality(cut); now < best) {
      best = now;
      best_cut = cut;
      kept = moved_.size();
    }
  }
  for (GainQueue& queue : queue_) queue.clear();
  for (std::size_t k = 0; k < moved_.size(); ++k) {
    locked_[moved_[k]] = 0;
    if (k >= kept) side[moved_[k]] ^= 1U;
  }
  moved_.clear();
  cut = best_cut;
  boundary_.clear();
  for (const Index v : touched_)
    if (degrees(graph, side, v).across > 0) boundary_.push_back(v);
  touched_.clear();
  return best < start;
}

} // namespace dirichlet::ordering
