// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "graph.h"

namespace dirichlet::ordering {

/// Where the vertices of gain queues stand: for each vertex its bucket (kNone if it is in no queue) and its neighbours
/// there. Queues of different vertices share one such set, also those of different threads.
struct QueueLinks {
  Scratch<Index> bucket, next, previous;

  void fit(Index size) {
    bucket.fit_filled(size, kNone);
    next.fit(size);
    previous.fit(size);
  }
  void clear(std::span<const Index> vertices) {
    for (const Index v : vertices) bucket[v] = kNone;
  }
};

/// Vertices in buckets by gain, the best on top (Fiduccia & Mattheyses 1982): every operation in O(1), but for the
/// descent of the top. Gains beyond ±range share the outermost buckets.
class GainQueue {
 public:
  GainQueue(Index range, QueueLinks& links)
      : range_(range), first_(static_cast<std::size_t>(2 * range + 1), kNone), links_(&links) {}

  [[nodiscard]] bool contains(Index v) const { return links_->bucket[v] != kNone; }
  /// The gain of a vertex in the queue, as far as the range goes.
  [[nodiscard]] Index gain(Index v) const { return links_->bucket[v] - range_; }

  void insert(Index v, Index gain) {
    const Index bucket = std::clamp(gain, -range_, range_) + range_;
    Index& first = first_[static_cast<std::size_t>(bucket)];
    links_->bucket[v] = bucket;
    links_->previous[v] = kNone;
    links_->next[v] = first;
    if (first != kNone) links_->previous[first] = v;
    first = v;
    top_ = std::max(top_, bucket);
  }

  void remove(Index v) {
    const Index after = links_->next[v], before = links_->previous[v];
    if (after != kNone) links_->previous[after] = before;
    (before != kNone ? links_->next[before] : first_[static_cast<std::size_t>(links_->bucket[v])]) = after;
    links_->bucket[v] = kNone;
  }

  void update(Index v, Index gain) {
    remove(v);
    insert(v, gain);
  }

  /// The vertex of the highest gain, of those the one that came last; kNone if there is none.
  [[nodiscard]] Index top() {
    while (top_ >= 0 && first_[static_cast<std::size_t>(top_)] == kNone) --top_;
    return top_ < 0 ? kNone : first_[static_cast<std::size_t>(top_)];
  }

  /// Empties the queue, except for its links. \param vertices among which are all that it holds.
  void drop(std::span<const Index> vertices) {
    for (const Index v : vertices)
      if (contains(v)) first_[static_cast<std::size_t>(links_->bucket[v])] = kNone;
    top_ = -1;
  }

 private:
  Index range_;
  Index top_ = -1;
  std::vector<Index> first_; // of each bucket
  QueueLinks* links_;
};

} // namespace dirichlet::ordering
