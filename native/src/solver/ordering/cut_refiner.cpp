// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_refiner.h"

#include <type_traits>
#include <utility>

namespace dirichlet::ordering {
namespace {

// Moves in vain before a pass gives up, and a quarter of the boundary.
constexpr std::size_t kPatience = 20;
// Later passes gain next to nothing, on the finest graph, where separators are improved after cuts, even sooner.
template <class G>
constexpr int kPasses = std::is_same_v<G, Graph> ? 2 : 4;

/// 1 if first <= i < last, 0 if not, without a branch.
Index within(Index i, Index first, Index last) {
  return static_cast<Index>(static_cast<std::uint32_t>(i - first) < static_cast<std::uint32_t>(last - first));
}

} // namespace

/// One pass: every vertex moves at most once, then what came after the best state is taken back.
template <class G>
class CutRefiner::Pass {
 public:
  Pass(CutRefiner& refiner, const G& graph, const Division& division, Regions& regions, VertexSet& boundary)
      : graph_(graph), division_(division), regions_(regions), boundary_(boundary), notes_(refiner.notes_),
        queue_(refiner.queue_), moves_(refiner.moves_), weight_{regions.weigh(division.first, division.split),
                                                                regions.weigh(division.split, division.last)},
        heaviest_(static_cast<Index>((std::int64_t{weight_[0]} + weight_[1]) * 65 / 100)) {
    moves_.clear();
  }

  /// \returns whether the cut became better.
  bool improve();
  void grow(Index seed);
  [[nodiscard]] Index cut() const { return cut_; }

 private:
  struct Ties {
    Index across = 0, inside = 0; ///< weight of the edges to the other side and to the same
    [[nodiscard]] Index gain() const { return across - inside; }
  };

  [[nodiscard]] Part side(Index v) const { return division_.side(regions_[v]); }
  [[nodiscard]] double score() const { return division_score(cut_, weight_[kLeft], weight_[kRight]); }
  [[nodiscard]] Ties ties(Index v, Part side) const;
  std::size_t enqueue_boundary();
  void enqueue(Index v, Part side, Index gain);
  Index choose();
  void move(Index v);
  void move_only(Index v, Part from);
  void end(std::size_t kept);

  const G& graph_;
  const Division& division_;
  Regions& regions_;
  VertexSet& boundary_;
  VertexNotes& notes_;
  std::array<GainQueue, 2>& queue_;
  std::vector<Move>& moves_;
  std::array<Index, 2> weight_;
  Index heaviest_; // a side may become
  Index cut_ = 0;
};

template <class G>
auto CutRefiner::Pass<G>::ties(Index v, Part side) const -> Ties {
  const Division division = division_;
  Index left = 0, right = 0;
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
    const Index region = regions_[graph_.neighbours[e]], weight = graph_.edge_weight(e);
    left += weight * within(region, division.first, division.split);
    right += weight * within(region, division.split, division.last);
  }
  return side == kLeft ? Ties{right, left} : Ties{left, right};
}

/// Starts the queues and cut_. \returns how many vertices there are.
template <class G>
std::size_t CutRefiner::Pass<G>::enqueue_boundary() {
  std::size_t count = 0;
  for (const Index v : boundary_.all()) {
    const Part side = this->side(v);
    const Ties own = ties(v, side);
    if (own.across == 0) continue;
    enqueue(v, side, own.gain());
    if (side == kLeft) cut_ += own.across;
    ++count;
  }
  return count;
}

template <class G>
bool CutRefiner::Pass<G>::improve() {
  const std::size_t patience = kPatience + enqueue_boundary() / 4;
  const double start = score();
  double best = start;
  Index best_cut = cut_;
  std::size_t kept = 0;
  while (moves_.size() < kept + patience) {
    const Index v = choose();
    if (v == kNone) break;
    move(v);
    if (const double now = score(); now < best) {
      best = now;
      best_cut = cut_;
      kept = moves_.size();
    }
  }
  cut_ = best_cut;
  end(kept);
  return best < start;
}

template <class G>
void CutRefiner::Pass<G>::grow(Index seed) {
  enqueue(seed, kRight, ties(seed, kRight).gain());
  for (Index v = seed; v != kNone && weight_[kLeft] < weight_[kRight]; v = queue_[kRight].top()) move(v);
  end(moves_.size());
}

template <class G>
void CutRefiner::Pass<G>::enqueue(Index v, Part side, Index gain) {
  notes_.gain[v] = gain;
  queue_[side].insert(v, gain);
}

/// The best vertex to move that does not overload a side; from the heavier side when in doubt.
template <class G>
Index CutRefiner::Pass<G>::choose() {
  const Part heavier = weight_[kRight] > weight_[kLeft] ? kRight : kLeft;
  GainQueue& others = queue_[opposite(heavier)];
  const Index load = weight_[heavier];
  const Index v = queue_[heavier].top();
  while (true) {
    const Index u = others.top();
    if (u == kNone || load > heaviest_ || (v != kNone && notes_.gain[v] >= notes_.gain[u])) return v;
    if (load + graph_.weight(u) <= heaviest_) return u;
    if (v != kNone) return v;
    others.remove(u);
    notes_.locked[u] = 1;
  }
}

template <class G>
void CutRefiner::Pass<G>::move(Index v) {
  const Part from = side(v), to = opposite(from);
  move_only(v, from);
  const Division d = division_;
  const auto [first, last] = from == kLeft ? std::pair(d.first, d.split) : std::pair(d.split, d.last);
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
    const Index u = graph_.neighbours[e], region = regions_[u];
    if (within(region, d.first, d.last) == 0 || notes_.locked[u] != 0) continue;
    const Index left_behind = within(region, first, last);
    if (notes_.links[0].bucket[u] != kNone) {
      notes_.gain[u] += (4 * left_behind - 2) * graph_.edge_weight(e);
      queue_[left_behind != 0 ? from : to].update(u, notes_.gain[u]);
    } else if (left_behind != 0) {
      boundary_.add(u);
      enqueue(u, from, ties(u, from).gain());
    }
  }
}

template <class G>
void CutRefiner::Pass<G>::move_only(Index v, Part from) {
  queue_[from].remove(v);
  notes_.locked[v] = 1;
  boundary_.add(v);
  moves_.push_back({v, regions_[v]});
  regions_.move(v, graph_.weight(v), division_.region_on(opposite(from)));
  weight_[from] -= graph_.weight(v);
  weight_[opposite(from)] += graph_.weight(v);
  cut_ -= notes_.gain[v];
}

/// Takes all moves but the first `kept` back.
template <class G>
void CutRefiner::Pass<G>::end(std::size_t kept) {
  for (GainQueue& queue : queue_) queue.drop(boundary_.all());
  notes_.links[0].clear(boundary_.all());
  for (const Index v : boundary_.all()) notes_.locked[v] = 0;
  for (; moves_.size() > kept; moves_.pop_back())
    regions_.move(moves_.back().vertex, graph_.weight(moves_.back().vertex), moves_.back().from);
}

void CutRefiner::grow(const WeightedGraph& graph, Index seed, Regions& regions, VertexSet& boundary) {
  constexpr Division kHalves{0, 1, 2};
  Pass(*this, graph, kHalves, regions, boundary).grow(seed);
}

template <class G>
Index CutRefiner::refine(const G& graph, const Division& division, Regions& regions, VertexSet& boundary) {
  for (int k = 1;; ++k) {
    Pass pass(*this, graph, division, regions, boundary);
    if (!pass.improve() || k == kPasses<G>) return pass.cut();
  }
}

template Index CutRefiner::refine(const Graph&, const Division&, Regions&, VertexSet&);
template Index CutRefiner::refine(const WeightedGraph&, const Division&, Regions&, VertexSet&);

} // namespace dirichlet::ordering
