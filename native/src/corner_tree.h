// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

struct Point2 {
  double x = 0, y = 0;
};

/// Points of the plane, each either marked or not, and which of the marked ones may lie in a triangle: a k-d tree,
/// halved along x or y, where the points reach farther. Keeps its memory from one set of points to the next.
class CornerTree {
 public:
  /// None is marked yet. Cost: O(n log n); nothing for few points, through which a search simply goes.
  void build(std::span<const Point2> points);

  /// Cost: O(log n).
  void mark(Index point, bool is_marked);

  [[nodiscard]] bool is_marked(Index point) const { return marked_[static_cast<std::size_t>(point)] != 0; }

  /// Whether `wanted(i)` holds for a marked point, of those in the counter-clockwise triangle, or so near to it that
  /// coordinates off by `margin` might bring them in, and maybe of others.
  /// Cost: about O(√n) for a triangle with few marked points inside.
  template <class Wanted>
  [[nodiscard]] bool any_in(const std::array<Point2, 3>& triangle, double margin, const Wanted& wanted) const {
    return any_in(Node{0, 0, points_.size()}, triangle, margin, wanted);
  }

 private:
  static constexpr std::size_t kLeaf = 16;

  struct Box {
    double left, right, low, high;
  };

  /// Points order_[begin … end); its halves are the nodes 2 number + 1 and 2 number + 2.
  struct Node {
    std::size_t number, begin, end;

    [[nodiscard]] bool is_leaf() const { return end - begin <= kLeaf; }
    [[nodiscard]] Node lower() const { return {2 * number + 1, begin, begin + (end - begin) / 2}; }
    [[nodiscard]] Node upper() const { return {2 * number + 2, begin + (end - begin) / 2, end}; }
  };

  void build(const Node& node);

  /// Whether all of the box is right of a side, whatever coordinates are off by `margin`.
  static bool is_outside(const Box& box, const std::array<Point2, 3>& triangle, double margin) {
    const Point2 middle{(box.left + box.right) / 2, (box.low + box.high) / 2};
    const double wide = (box.right - box.left) / 2, tall = (box.high - box.low) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 &a = triangle[i], &b = triangle[(i + 1) % 3];
      const double x = b.x - a.x, y = b.y - a.y, to_x = middle.x - a.x, to_y = middle.y - a.y;
      const double most = x * to_y - y * to_x + std::abs(x) * tall + std::abs(y) * wide;
      const double sizes = std::abs(x) + std::abs(y) + std::abs(to_x) + std::abs(to_y) + wide + tall;
      if (most < -margin * sizes) return true;
    }
    return false;
  }

  template <class Wanted>
  [[nodiscard]] bool any_in(const Node& node, const std::array<Point2, 3>& triangle, double margin,
                            const Wanted& wanted) const {
    if (node.is_leaf())
      return std::any_of(order_.begin() + static_cast<std::ptrdiff_t>(node.begin),
                         order_.begin() + static_cast<std::ptrdiff_t>(node.end),
                         [&](Index i) { return is_marked(i) && wanted(i); });
    if (count_[node.number] == 0 || is_outside(box_[node.number], triangle, margin)) return false;
    return any_in(node.lower(), triangle, margin, wanted) || any_in(node.upper(), triangle, margin, wanted);
  }

  std::span<const Point2> points_;
  std::vector<Index> order_;          ///< of the points, by node
  std::vector<std::size_t> place_;    ///< (n,) where each is in it
  std::vector<unsigned char> marked_; ///< (n,)
  std::vector<Box> box_;              ///< of nodes that are no leaves
  std::vector<Index> count_;          ///< the same: marked points in them
};

} // namespace dirichlet
