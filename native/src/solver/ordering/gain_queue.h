// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "graph.h"

namespace dirichlet::ordering {

/// Vertices in buckets by gain, the best on top (Fiduccia & Mattheyses 1982): every operation in O(1), but for the
/// descent of the top. Gains beyond ±range share the outermost buckets.
class GainQueue {
 public:
  explicit GainQueue(Index range) : range_(range), first_(static_cast<std::size_t>(2 * range + 1), kNone) {}

  /// Room for vertices 0 … size - 1. The queue must be empty.
  void fit(Index size) {
    bucket_.fit_filled(size, kNone);
    next_.fit(size);
    previous_.fit(size);
  }

  [[nodiscard]] bool contains(Index v) const { return bucket_[v] != kNone; }
  /// The gain of a vertex in the queue, as far as the range goes.
  [[nodiscard]] Index gain(Index v) const { return bucket_[v] - range_; }

  void insert(Index v, Index gain) {
    const Index bucket = std::clamp(gain, -range_, range_) + range_;
    Index& first = first_[static_cast<std::size_t>(bucket)];
    bucket_[v] = bucket;
    previous_[v] = kNone;
    next_[v] = first;
    if (first != kNone) previous_[first] = v;
    first = v;
    top_ = std::max(top_, bucket);
  }

  void remove(Index v) {
    const Index after = next_[v], before = previous_[v];
    if (after != kNone) previous_[after] = before;
    (before != kNone ? next_[before] : first_[static_cast<std::size_t>(bucket_[v])]) = after;
    bucket_[v] = kNone;
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

  void clear() {
    for (Index v = top(); v != kNone; v = top()) remove(v);
  }

  static constexpr Index kNone = -1;

 private:
  Index range_;
  Index top_ = -1;
  std::vector<Index> first_; // of each bucket
  Scratch<Index> bucket_, next_, previous_;
};

} // namespace dirichlet::ordering
