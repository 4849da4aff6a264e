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

struct Ties {
  Index across = 0, inside = 0; ///< weight of the edges to the other side and to the same
  [[nodiscard]] Index gain() const { return across - inside; }
};

template <class G>
Ties ties(const G& graph, const Division& division, Index v) {
  Ties result;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    (division.part[graph.neighbours[e]] == division.part[v] ? result.inside : result.across) += graph.edge_weight(e);
  return result;
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
  begin_pass();
  enqueue(division, seed, ties(graph, division, seed).gain());
  for (Index v = seed; v != kNone && division.weight[kLeft] < division.weight[kRight]; v = queue_[kRight].top())
    move(graph, v, division);
  end_pass(moved_.size(), division);
  division.boundary = touched_;
}

void CutRefiner::refine(const CoarseGraph& graph, Division& division) {
  refine_any(graph, division);
}
void CutRefiner::refine(const Graph& graph, Division& division) {
  refine_any(graph, division);
}

template <class G>
void CutRefiner::refine_any(const G& graph, Division& division) {
  fit(graph.size);
  for (int pass = 0; pass < kPasses && improve(graph, division); ++pass) {
  }
}

/// One pass: every vertex moves at most once, then what came after the best state is taken back.
template <class G>
bool CutRefiner::improve(const G& graph, Division& division) {
  begin_pass();
  for (const Index v : division.boundary)
    if (const Ties own = ties(graph, division, v); own.across > 0) enqueue(division, v, own.gain());
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
  end_pass(kept, division);
  division.boundary.clear();
  for (const Index v : touched_)
    if (ties(graph, division, v).across > 0) division.boundary.push_back(v);
  return best < start;
}

void CutRefiner::begin_pass() {
  moved_.clear();
  touched_.clear();
}

void CutRefiner::enqueue(const Division& division, Index v, Index gain) {
  gain_[v] = gain;
  queue_[division.part[v]].insert(v, gain);
  touched_.push_back(v);
}

/// The best vertex to move that does not overload a side; from the heavier side when in doubt.
template <class G>
Index CutRefiner::choose(const G& graph, const Division& division, Index heaviest) {
  const Part heavier = division.weight[kRight] > division.weight[kLeft] ? kRight : kLeft;
  GainQueue& others = queue_[1 - heavier];
  const Index load = division.weight[heavier];
  const Index v = queue_[heavier].top();
  while (true) {
    const Index u = others.top();
    if (u == kNone || load > heaviest || (v != kNone && gain_[v] >= gain_[u])) return v;
    if (load + graph.weight(u) <= heaviest) return u;
    if (v != kNone) return v;
    others.remove(u);
    locked_[u] = 1;
  }
}

template <class G>
void CutRefiner::move(const G& graph, Index v, Division& division) {
  const std::uint8_t from = division.part[v], to = 1 - from;
  queue_[from].remove(v);
  locked_[v] = 1;
  moved_.push_back(v);
  division.part[v] = to;
  division.weight[from] -= graph.weight(v);
  division.weight[to] += graph.weight(v);
  division.cut -= gain_[v];
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
    const Index u = graph.neighbours[e];
    if (locked_[u] != 0) continue;
    const bool left_behind = division.part[u] == from;
    if (GainQueue& queue = queue_[division.part[u]]; queue.contains(u)) {
      gain_[u] += (left_behind ? 2 : -2) * graph.edge_weight(e);
      queue.update(u, gain_[u]);
    } else if (left_behind) {
      enqueue(division, u, ties(graph, division, u).gain());
    }
  }
}

/// Takes all moves but the first `kept` back. touched_ stays for the caller to look at.
void CutRefiner::end_pass(std::size_t kept, Division& division) {
  for (GainQueue& queue : queue_) queue.clear();
  for (const Index v : touched_) locked_[v] = 0;
  for (std::size_t k = kept; k < moved_.size(); ++k) division.part[moved_[k]] ^= 1U;
}

} // namespace dirichlet::ordering
