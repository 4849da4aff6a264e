// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_refiner.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = GainQueue::kNone;
constexpr std::size_t kPatience = 20; // moves in vain before a pass gives up, and a quarter of the boundary
constexpr int kPasses = 6;

Index heaviest_side(const Division& division) {
  const std::int64_t total = std::int64_t{division.weight[0]} + division.weight[1];
  return static_cast<Index>(total * 65 / 100);
}

/// Weight of the edges from v to the other side, less that to its own.
template <class G>
Index gain_of_moving(const G& graph, const Division& division, Index v, bool& on_boundary) {
  Index across = 0, inside = 0;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    (division.part[graph.neighbours[e]] == division.part[v] ? inside : across) += graph.edge_weight(e);
  on_boundary = across > 0;
  return across - inside;
}

} // namespace

void CutRefiner::fit(Index size) {
  for (GainQueue& queue : queue_) queue.fit(size);
  gain_.fit(size);
  locked_.fit_filled(size, 0);
}

void CutRefiner::grow(const CoarseGraph& graph, Index seed, Division& division) {
  fit(graph.size);
  std::fill_n(division.part.fit(graph.size), graph.size, std::uint8_t{kRight});
  division.weight = {};
  for (Index v = 0; v < graph.size; ++v) division.weight[kRight] += graph.weight(v);
  division.cut = 0;
  enqueue(graph, division, seed);
  for (Index v = seed; v != kNone && division.weight[kLeft] < division.weight[kRight]; v = queue_[kRight].top())
    move(graph, v, division);
  division.boundary = touched_;
  end_pass(moved_.size(), division);
}

void CutRefiner::refine(const CoarseGraph& graph, Division& division) { refine_any(graph, division); }
void CutRefiner::refine(const Graph& graph, Division& division) { refine_any(graph, division); }

template <class G>
void CutRefiner::refine_any(const G& graph, Division& division) {
  fit(graph.size);
  for (int pass = 0; pass < kPasses && improve(graph, division); ++pass) {
  }
}

/// One pass: every vertex moves at most once, then what came after the best state is taken back.
template <class G>
bool CutRefiner::improve(const G& graph, Division& division) {
  bool on_boundary = false;
  for (const Index v : division.boundary)
    if (!queue_[division.part[v]].contains(v)) {
      gain_of_moving(graph, division, v, on_boundary);
      if (on_boundary) enqueue(graph, division, v);
    }
  const Index heaviest = heaviest_side(division);
  const double start = division.score();
  double best = start;
  auto best_weight = division.weight;
  Index best_cut = division.cut;
  std::size_t kept = 0;
  const std::size_t patience = kPatience + touched_.size() / 4;
  while (moved_.size() < kept + patience) {
    const Index v = choose(graph, division, heaviest);
    if (v == kNone) break;
    move(graph, v, division);
    if (const double now = division.score(); now < best) {
      best = now;
      best_weight = division.weight;
      best_cut = division.cut;
      kept = moved_.size();
    }
  }
  division.weight = best_weight;
  division.cut = best_cut;
  division.boundary.clear();
  end_pass(kept, division);
  return best < start;
}

} // namespace dirichlet::ordering
