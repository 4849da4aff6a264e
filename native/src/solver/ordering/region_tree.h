// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "regions.h"

namespace dirichlet::ordering {

/// The tree of the divisions that made regions 0 … n: division k is the one between region k and region k + 1.
class RegionTree {
 public:
  struct Node {
    Index first = 0, last = 0; ///< it divides regions first … last - 1
    Index parent = kNone, left = kNone, right = kNone;
  };

  /// \param depths of the divisions; between any two of the same depth lies a shallower one. Cost: O(n).
  explicit RegionTree(std::span<const std::uint8_t> depths);

  [[nodiscard]] Index root() const { return root_; } ///< kNone for a single region
  [[nodiscard]] Index size() const { return static_cast<Index>(nodes_.size()); }
  [[nodiscard]] const Node& operator[](Index k) const { return nodes_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] Division division(Index k) const { return {(*this)[k].first, k + 1, (*this)[k].last}; }
  /// The division that parts two regions, low < high.
  [[nodiscard]] Index between(Index low, Index high) const {
    Index k = low;
    while ((*this)[k].last <= high) k = (*this)[k].parent;
    return k;
  }

  /// The region that holds the separator of a division.
  [[nodiscard]] static constexpr Index separator(Index division) { return Division::kUndecided - 1 - division; }
  [[nodiscard]] static constexpr Index division_of(Index separator) { return Division::kUndecided - 1 - separator; }

 private:
  std::vector<Node> nodes_;
  Index root_ = kNone;
};

} // namespace dirichlet::ordering
