// SPDX-License-Identifier: GPL-3.0-or-later
#include "separator.h"

#include <cstdlib>

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = GainQueue::kNone;
constexpr std::size_t kPatience = 20; // moves in vain before a pass gives up
constexpr int kPasses = 6;

} // namespace

const std::uint8_t* Separator::separate(const Graph& graph, const std::uint8_t* side) {
  part_.fit(graph.size);
  locked_.fit_filled(graph.size, 0);
  for (GainQueue& queue : queue_) queue.fit(graph.size);
  size_ = {};
  for (Index v = 0; v < graph.size; ++v) ++size_[part_[v] = side[v]];
  largest_ = graph.size / 2 + graph.size / 10;
  cover_cut(graph);
  for (int pass = 0; pass < kPasses && improve(graph); ++pass) {
  }
  return part_.data();
}

/// The separator to begin with: the ends of cut edges on the side with fewer of them.
void Separator::cover_cut(const Graph& graph) {
  std::array<std::vector<Index>, 2> ends;
  for (Index v = 0; v < graph.size; ++v)
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (part_[graph.neighbours[e]] != part_[v]) {
        ends[part_[v]].push_back(v);
        break;
      }
  const Part from = ends[1].size() < ends[0].size() ? kRight : kLeft;
  separator_ = ends[from];
  for (const Index v : separator_) part_[v] = kSeparator;
  size_[kSeparator] = static_cast<Index>(separator_.size());
  size_[from] -= size_[kSeparator];
}

void Separator::enqueue(const Graph& graph, Index v) {
  std::array<Index, 3> neighbours{};
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) ++neighbours[part_[graph.neighbours[e]]];
  queue_[kLeft].insert(v, 1 - neighbours[kRight]);
  queue_[kRight].insert(v, 1 - neighbours[kLeft]);
}

void Separator::dequeue(Index v) {
  for (GainQueue& queue : queue_)
    if (queue.contains(v)) queue.remove(v);
}

/// The best move that does not overload a side, towards the smaller side when in doubt.
bool Separator::choose(Index& v, Part& to) {
  while (true) {
    const Index left = queue_[kLeft].top(), right = queue_[kRight].top();
    if (left == kNone && right == kNone) return false;
    const Part smaller = size_[kRight] < size_[kLeft] ? kRight : kLeft;
    to = smaller;
    if (left == kNone || right == kNone)
      to = left == kNone ? kRight : kLeft;
    else if (const Index a = queue_[kLeft].gain(left), b = queue_[kRight].gain(right); a != b)
      to = b > a ? kRight : kLeft;
    v = to == kLeft ? left : right;
    if (to == smaller || size_[to] < largest_) return true;
    queue_[to].remove(v);
  }
}

/// Gives v a new part and its neighbours in the separator their new gains.
void Separator::relabel(const Graph& graph, Index v, Part to) {
  const auto before = static_cast<Part>(part_[v]);
  changes_.push_back({v, before});
  --size_[before];
  ++size_[to];
  part_[v] = to;
  const Part side = before == kSeparator ? to : before;
  GainQueue& away = queue_[1 - side]; // where moves pull the neighbours on v's side into the separator
  const Index difference = before == kSeparator ? -1 : 1;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    if (const Index u = graph.neighbours[e]; away.contains(u)) away.update(u, away.gain(u) + difference);
}

void Separator::move(const Graph& graph, Index v, Part to) {
  dequeue(v);
  locked_[v] = 1;
  relabel(graph, v, to);
  const Part from = to == kLeft ? kRight : kLeft;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
    const Index u = graph.neighbours[e];
    if (part_[u] != from) continue;
    relabel(graph, u, kSeparator);
    touched_.push_back(u);
    if (locked_[u] == 0) enqueue(graph, u);
  }
}

/// One pass: no vertex leaves the separator twice, then what came after the best state is taken back.
bool Separator::improve(const Graph& graph) {
  for (const Index v : separator_) enqueue(graph, v);
  touched_ = separator_;
  const auto imbalance = [&] { return std::abs(size_[kLeft] - size_[kRight]); };
  auto best = std::pair(size_[kSeparator], imbalance());
  const auto start = best;
  std::array<Index, 3> best_size = size_;
  std::size_t kept = 0;
  const std::size_t patience = kPatience + separator_.size() / 4;
  std::size_t in_vain = 0;
  Index v;
  Part to;
  while (in_vain < patience && choose(v, to)) {
    move(graph, v, to);
    ++in_vain;
    if (const auto now = std::pair(size_[kSeparator], imbalance()); now < best) {
      best = now;
      best_size = size_;
      kept = changes_.size();
      in_vain = 0;
    }
  }
  for (GainQueue& queue : queue_) queue.clear();
  while (changes_.size() > kept) {
    part_[changes_.back().vertex] = changes_.back().before;
    locked_[changes_.back().vertex] = 0;
    changes_.pop_back();
  }
  for (const Change& change : changes_) locked_[change.vertex] = 0;
  changes_.clear();
  size_ = best_size;
  separator_.clear();
  for (const Index u : touched_)
    if (part_[u] == kSeparator && locked_[u] == 0) {
      separator_.push_back(u);
      locked_[u] = 1; // a vertex may have been touched twice
    }
  for (const Index u : separator_) locked_[u] = 0;
  return best < start;
}

} // namespace dirichlet::ordering
