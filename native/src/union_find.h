// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

/// Disjoint sets of 0 … n − 1. The root of a set is its lowest member, so that labels do not depend on the order in
/// which sets were united. Paths are halved on the way.
class UnionFind {
 public:
  explicit UnionFind(Index n) : parent_(static_cast<std::size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index find(Index i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }

  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    at(b) = a;
  }

  /// Numbers the sets by their lowest member and writes every member's number; leaves alone where member(i) is false.
  /// \returns how many there are.
  template <class Member>
  Index label(Member member, std::vector<Index>& labels) {
    Index count = 0;
    for (Index i = 0; i < static_cast<Index>(parent_.size()); ++i) {
      if (!member(i)) continue;
      const Index root = find(i);
      labels[static_cast<std::size_t>(i)] = root == i ? count++ : labels[static_cast<std::size_t>(root)];
    }
    return count;
  }

 private:
  Index& at(Index i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<Index> parent_;
};

} // namespace dirichlet
