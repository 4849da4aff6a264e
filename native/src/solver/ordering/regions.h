// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "graph.h"

namespace dirichlet::ordering {

/// The sides of a division. Vertices outside belong to other branches of the dissection.
enum Part : std::uint8_t { kLeft = 0, kRight = 1, kSeparator = 2, kOutside = 3 };

constexpr Part opposite(Part side) {
  return side == kLeft ? kRight : kLeft;
}

/// A division of the regions first … last - 1 of a graph: those below `split` lie on its left, the others on its right.
struct Division {
  Index first, split, last;

  [[nodiscard]] Part side(Index region) const {
    if (region < first) return region == kUndecided ? kSeparator : kOutside;
    return region >= last ? kOutside : region >= split ? kRight : kLeft;
  }
  /// Some region on a side.
  [[nodiscard]] Index region_on(Part side) const { return side == kLeft ? first : split; }

  static constexpr Index kUndecided = -1; ///< the region of vertices in a separator that is being looked for
};

/// The regions into which a graph is dissected, numbered from left to right. Threads share them, each to work on
/// another branch of the dissection; what they see of other branches is only that it is not theirs.
class Regions {
 public:
  void fit(Index vertices) { region_.fit(vertices); }

  /// The region of a vertex; below 0 if it is in a separator.
  [[nodiscard]] Index operator[](Index vertex) const { return region_[vertex].load(std::memory_order_relaxed); }
  void set(Index vertex, Index region) { region_[vertex].store(region, std::memory_order_relaxed); }
  /// The same, keeping the weights right.
  void move(Index vertex, Index vertex_weight, Index to) {
    if (const Index from = (*this)[vertex]; from >= 0) weight[static_cast<std::size_t>(from)] -= vertex_weight;
    if (to >= 0) weight[static_cast<std::size_t>(to)] += vertex_weight;
    set(vertex, to);
  }
  /// What regions first … last - 1 weigh.
  [[nodiscard]] Index weigh(Index first, Index last) const {
    Index sum = 0;
    for (Index r = first; r < last; ++r) sum += weight[static_cast<std::size_t>(r)];
    return sum;
  }
  [[nodiscard]] std::size_t count() const { return weight.size(); }

  std::vector<Index> weight;       ///< of the vertices of each region
  std::vector<std::uint8_t> depth; ///< of each division, that is, between region k and region k + 1

 private:
  Scratch<std::atomic<Index>> region_;
};

/// What makes one division better than another: less between the sides, and sides of about the same weight, since what
/// an uneven division leaves whole must be cut again (found by experiment: twice the square of the tilt).
inline double division_score(Index between, Index left, Index right) {
  const double tilt = (static_cast<double>(left) - right) / (2 * (static_cast<double>(left) + right));
  return between * (1 + 2 * tilt * tilt);
}

} // namespace dirichlet::ordering
