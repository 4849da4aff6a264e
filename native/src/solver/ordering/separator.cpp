// SPDX-License-Identifier: GPL-3.0-or-later
#include "separator.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = GainQueue::kNone;
constexpr std::size_t kPatience = 30; // moves in vain before a pass gives up, and a quarter of the separator
constexpr int kPasses = 10;

} // namespace

void Separator::separate(const Graph& graph, Division& division) {
  locked_.fit_filled(graph.size, 0);
  for (GainQueue& queue : queue_) queue.fit(graph.size);
  largest_ = graph.size - graph.size / 10 * 3;
  cover_cut(division);
  for (int pass = 0; pass < kPasses && improve(graph, division.part.data()); ++pass) {
  }
}

/// The separator to begin with: the boundary of the side with fewer vertices on it.
void Separator::cover_cut(Division& division) {
  std::array<Index, 2> ends{};
  for (const Index v : division.boundary) ++ends[division.part[v]];
  const Part from = ends[kRight] < ends[kLeft] ? kRight : kLeft;
  separator_.clear();
  for (const Index v : division.boundary)
    if (division.part[v] == from) {
      separator_.push_back(v);
      division.part[v] = kSeparator;
    }
  size_ = {division.weight[kLeft], division.weight[kRight], ends[from]};
  size_[from] -= ends[from];
}

/// One pass: no vertex leaves the separator twice, then what came after the best state is taken back.
bool Separator::improve(const Graph& graph, std::uint8_t* part) {
  for (const Index v : separator_) enqueue(graph, part, v);
  touched_ = separator_;
  const double start = score();
  double best = start;
  std::array<Index, 3> best_size = size_;
  std::size_t kept = 0;
  const std::size_t patience = kPatience + separator_.size() / 4;
  Index v = kNone;
  Part to = kLeft;
  for (std::size_t in_vain = 0; in_vain < patience && choose(v, to); ++in_vain) {
    move(graph, v, to, part);
    if (const double now = score(); now < best) {
      best = now;
      best_size = size_;
      kept = changes_.size();
      in_vain = 0;
    }
  }
  end_pass(kept, part);
  size_ = best_size;
  return best < start;
}

/// A vertex that leaves pulls its neighbours on the other side in.
void Separator::enqueue(const Graph& graph, const std::uint8_t* part, Index v) {
  std::array<Index, 3> neighbours{};
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) ++neighbours[part[graph.neighbours[e]]];
  queue_[kLeft].insert(v, 1 - neighbours[kRight]);
  queue_[kRight].insert(v, 1 - neighbours[kLeft]);
}

/// The best move that does not overload a side; to the smaller side when in doubt.
bool Separator::choose(Index& v, Part& to) {
  const Part smaller = size_[kRight] < size_[kLeft] ? kRight : kLeft;
  const Part larger = smaller == kLeft ? kRight : kLeft;
  const Index small = queue_[smaller].top(), large = queue_[larger].top();
  const bool grow_larger = large != kNone && size_[larger] < largest_ &&
                           (small == kNone || queue_[larger].gain(large) > queue_[smaller].gain(small));
  to = grow_larger ? larger : smaller;
  v = grow_larger ? large : small;
  return v != kNone;
}

void Separator::move(const Graph& graph, Index v, Part to, std::uint8_t* part) {
  for (GainQueue& queue : queue_) queue.remove(v);
  locked_[v] = 1;
  relabel(graph, v, to, part);
  const Part from = to == kLeft ? kRight : kLeft;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
    const Index u = graph.neighbours[e];
    if (part[u] != from) continue;
    relabel(graph, u, kSeparator, part);
    touched_.push_back(u);
    if (locked_[u] == 0) enqueue(graph, part, u);
  }
}

/// Gives v a new part and its neighbours in the separator their new gains.
void Separator::relabel(const Graph& graph, Index v, Part to, std::uint8_t* part) {
  const auto before = static_cast<Part>(part[v]);
  changes_.push_back({v, before});
  --size_[before];
  ++size_[to];
  part[v] = to;
  const Part side = before == kSeparator ? to : before;
  GainQueue& away = queue_[1 - side]; // moves that pull the neighbours on v's side in
  const Index difference = before == kSeparator ? -1 : 1;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    if (const Index u = graph.neighbours[e]; away.contains(u)) away.update(u, away.gain(u) + difference);
}

/// Takes all changes but the first `kept` back and lists what is in the separator then, once each.
void Separator::end_pass(std::size_t kept, std::uint8_t* part) {
  for (GainQueue& queue : queue_) queue.clear();
  for (const Change& change : changes_) locked_[change.vertex] = 0;
  for (; changes_.size() > kept; changes_.pop_back()) part[changes_.back().vertex] = changes_.back().before;
  changes_.clear();
  separator_.clear();
  for (const Index v : touched_)
    if (part[v] == kSeparator && locked_[v] == 0) {
      separator_.push_back(v);
      locked_[v] = 1;
    }
  for (const Index v : separator_) locked_[v] = 0;
}

} // namespace dirichlet::ordering
