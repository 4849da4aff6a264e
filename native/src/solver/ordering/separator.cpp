// SPDX-License-Identifier: GPL-3.0-or-later
#include "separator.h"

#include <utility>

namespace dirichlet::ordering {
namespace {

constexpr std::size_t kPatience = 10; // moves in vain before a pass gives up, and a quarter of the separator
constexpr int kPasses = 3;

} // namespace

class Separator::Search {
 public:
  Search(Separator& own, const Graph& graph, const Division& division, Regions& regions, VertexSet& boundary)
      : graph_(graph), division_(division), regions_(regions), boundary_(boundary),
        own_(own), size_{regions.weigh(division.first, division.split), regions.weigh(division.split, division.last),
                         0},
        largest_((size_[kLeft] + size_[kRight]) / 10 * 7) {}

  void cover_cut();
  bool improve();

 private:
  [[nodiscard]] Part side(Index v) const { return division_.side(regions_[v]); }
  [[nodiscard]] bool has_neighbour_on(Part side, Index v) const;
  void enqueue(Index v);
  bool choose(Index& v, Part& to);
  void move(Index v, Part to);
  void relabel(Index v, Part before, Part after, Index region);
  void end_pass(std::size_t kept);
  [[nodiscard]] double score() const { return division_score(size_[kSeparator], size_[kLeft], size_[kRight]); }

  const Graph& graph_;
  const Division& division_;
  Regions& regions_;
  VertexSet& boundary_;
  Separator& own_;
  std::array<Index, 3> size_;
  Index largest_; // a side that is not to grow beyond it
};

/// The separator to begin with: the boundary of the side with fewer vertices on it.
void Separator::Search::cover_cut() {
  auto& ends = own_.ends_;
  for (auto& side : ends) side.clear();
  for (const Index v : boundary_.all()) {
    const Part side = this->side(v);
    if (has_neighbour_on(opposite(side), v)) ends[side].push_back(v);
  }
  const Part from = ends[kRight].size() < ends[kLeft].size() ? kRight : kLeft;
  std::swap(own_.separator_, ends[from]);
  for (const Index v : own_.separator_) regions_.move(v, 1, Division::kUndecided);
  size_[kSeparator] = static_cast<Index>(own_.separator_.size());
  size_[from] -= size_[kSeparator];
}

bool Separator::Search::has_neighbour_on(Part side, Index v) const {
  return std::any_of(graph_.neighbours + graph_.offsets[v], graph_.neighbours + graph_.offsets[v + 1],
                     [&](Index u) { return this->side(u) == side; });
}

/// One pass: no vertex leaves the separator twice, then what came after the best state is taken back.
bool Separator::Search::improve() {
  for (const Index v : own_.separator_) enqueue(v);
  own_.touched_ = own_.separator_;
  own_.changes_.clear();
  const double start = score();
  double best = start;
  std::array<Index, 3> best_size = size_;
  std::size_t kept = 0;
  const std::size_t patience = kPatience + own_.separator_.size() / 4;
  Index v = kNone;
  Part to = kLeft;
  for (std::size_t in_vain = 0; in_vain < patience && choose(v, to); ++in_vain) {
    move(v, to);
    if (const double now = score(); now < best) {
      best = now;
      best_size = size_;
      kept = own_.changes_.size();
      in_vain = 0;
    }
  }
  end_pass(kept);
  size_ = best_size;
  return best < start;
}

/// A vertex that leaves pulls its neighbours on the other side in.
void Separator::Search::enqueue(Index v) {
  std::array<Index, 4> neighbours{};
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) ++neighbours[side(graph_.neighbours[e])];
  own_.queue_[kLeft].insert(v, 1 - neighbours[kRight]);
  own_.queue_[kRight].insert(v, 1 - neighbours[kLeft]);
}

/// The best move that does not overload a side; to the smaller side when in doubt.
bool Separator::Search::choose(Index& v, Part& to) {
  const Part smaller = size_[kRight] < size_[kLeft] ? kRight : kLeft;
  const Part larger = opposite(smaller);
  auto& queue = own_.queue_;
  const Index small = queue[smaller].top(), large = queue[larger].top();
  const bool grow_larger = large != kNone && size_[larger] < largest_ &&
                           (small == kNone || queue[larger].gain(large) > queue[smaller].gain(small));
  to = grow_larger ? larger : smaller;
  v = grow_larger ? large : small;
  return v != kNone;
}

void Separator::Search::move(Index v, Part to) {
  for (GainQueue& queue : own_.queue_) queue.remove(v);
  own_.notes_.locked[v] = 1;
  relabel(v, kSeparator, to, division_.region_on(to));
  const Part from = opposite(to);
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e) {
    const Index u = graph_.neighbours[e];
    if (side(u) != from) continue;
    relabel(u, from, kSeparator, Division::kUndecided);
    own_.touched_.push_back(u);
    boundary_.add(u);
    if (own_.notes_.locked[u] == 0) enqueue(u);
  }
}

/// Gives v a new region and its neighbours in the separator their new gains.
void Separator::Search::relabel(Index v, Part before, Part after, Index region) {
  own_.changes_.push_back({v, regions_[v]});
  --size_[before];
  ++size_[after];
  regions_.move(v, 1, region);
  const Part side = before == kSeparator ? after : before;
  GainQueue& away = own_.queue_[opposite(side)]; // moves that pull the neighbours on v's side in
  const Index difference = before == kSeparator ? -1 : 1;
  for (Index e = graph_.offsets[v]; e < graph_.offsets[v + 1]; ++e)
    if (const Index u = graph_.neighbours[e]; this->side(u) == kSeparator && away.contains(u))
      away.update(u, away.gain(u) + difference);
}

/// Takes all changes but the first `kept` back and lists what is in the separator then, once each.
void Separator::Search::end_pass(std::size_t kept) {
  for (GainQueue& queue : own_.queue_) queue.drop(own_.touched_);
  for (QueueLinks& links : own_.notes_.links) links.clear(own_.touched_);
  auto& locked = own_.notes_.locked;
  auto& changes = own_.changes_;
  for (const Change& change : changes) locked[change.vertex] = 0;
  for (; changes.size() > kept; changes.pop_back()) regions_.move(changes.back().vertex, 1, changes.back().before);
  own_.separator_.clear();
  for (const Index v : own_.touched_)
    if (regions_[v] == Division::kUndecided && locked[v] == 0) {
      own_.separator_.push_back(v);
      locked[v] = 1;
    }
  for (const Index v : own_.separator_) locked[v] = 0;
}

void Separator::separate(const Graph& graph, const Division& division, Index name, Regions& regions,
                         VertexSet& boundary) {
  Search search(*this, graph, division, regions, boundary);
  search.cover_cut();
  for (int pass = 0; pass < kPasses && search.improve(); ++pass) {
  }
  for (const Index v : separator_) regions.set(v, name);
}

} // namespace dirichlet::ordering
