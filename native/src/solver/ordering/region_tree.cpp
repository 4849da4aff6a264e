// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_tree.h"

namespace dirichlet::ordering {

/// From left to right; divisions whose right side is still open wait in a stack, the deepest on top.
RegionTree::RegionTree(std::span<const std::uint8_t> depths) : nodes_(depths.size()) {
  const auto at = [](auto& array, Index k) -> auto& {
    return array[static_cast<std::size_t>(k)];
  };
  std::vector<Index> open;
  for (Index k = 0; k < size(); ++k) {
    Node& node = at(nodes_, k);
    for (; !open.empty() && at(depths, open.back()) > at(depths, k); open.pop_back()) {
      node.left = open.back();
      at(nodes_, node.left).last = k + 1;
    }
    if (!open.empty()) {
      node.first = open.back() + 1;
      at(nodes_, open.back()).right = k;
    }
    open.push_back(k);
  }
  for (const Index k : open) at(nodes_, k).last = size() + 1;
  if (!open.empty()) root_ = open.front();
  for (Index k = 0; k < size(); ++k)
    for (const Index child : {at(nodes_, k).left, at(nodes_, k).right})
      if (child != kNone) at(nodes_, child).parent = k;
}

} // namespace dirichlet::ordering
