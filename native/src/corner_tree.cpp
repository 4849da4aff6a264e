// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_tree.h"

#include <numeric>

namespace dirichlet {

void CornerTree::build(std::span<const Point2> points) {
  points_ = points;
  order_.resize(points.size());
  place_.resize(points.size());
  marked_.assign(points.size(), 0);
  std::iota(order_.begin(), order_.end(), Index{0});
  box_.clear();
  count_.clear();
  build(Node{0, 0, points.size()});
  for (std::size_t i = 0; i < order_.size(); ++i) place_[static_cast<std::size_t>(order_[i])] = i;
}

void CornerTree::build(const Node& node) {
  if (node.is_leaf()) return;
  const auto at = [&](Index i) { return points_[static_cast<std::size_t>(i)]; };
  const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(node.begin),
             end = order_.begin() + static_cast<std::ptrdiff_t>(node.end),
             middle = order_.begin() + static_cast<std::ptrdiff_t>(node.upper().begin);
  Box box{at(*begin).x, at(*begin).x, at(*begin).y, at(*begin).y};
  for (auto i = begin; i != end; ++i) {
    box.left = std::min(box.left, at(*i).x);
    box.right = std::max(box.right, at(*i).x);
    box.low = std::min(box.low, at(*i).y);
    box.high = std::max(box.high, at(*i).y);
  }
  const bool along_x = box.right - box.left >= box.high - box.low;
  std::nth_element(begin, middle, end,
                   [&](Index i, Index j) { return along_x ? at(i).x < at(j).x : at(i).y < at(j).y; });
  if (box_.size() <= node.number) {
    box_.resize(node.number + 1);
    count_.resize(node.number + 1);
  }
  box_[node.number] = box;
  count_[node.number] = 0;
  build(node.lower());
  build(node.upper());
}

void CornerTree::mark(Index point, bool is_marked) {
  const auto i = static_cast<std::size_t>(point);
  if ((marked_[i] != 0) == is_marked) return;
  marked_[i] = is_marked ? 1 : 0;
  for (Node node{0, 0, points_.size()}; !node.is_leaf();
       node = place_[i] < node.upper().begin ? node.lower() : node.upper())
    count_[node.number] += is_marked ? 1 : -1;
}

} // namespace dirichlet
