// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

struct Point2 {
  double x = 0, y = 0;
};

/// Cuts polygons into triangles ear by ear; keeps its memory from one to the next.
///
/// An ear is a corner that turns left and whose open triangle no side of the polygon enters. Cutting one off leaves a
/// polygon of the same kind, even where sides touch or run back along each other, as in a keyhole. A corner on a
/// straight line (as near as rounding can tell) is cut off only when there is no ear, so that flat triangles appear
/// only where the polygon itself is flat.
class EarClipper {
 public:
  /// \param polygon   counter-clockwise, of size about 1: rounding is judged against that.
  /// \param triangles receives the corners' places in `polygon`, three for each of the size - 2 triangles.
  /// \returns false if no ear is left before the end, which is when the polygon crosses itself.
  bool cut(std::span<const Point2> polygon, std::vector<Index>& triangles);

 private:
  void start();
  void remove(Index corner, std::vector<Index>& triangles);
  bool is_ear(Index corner);
  [[nodiscard]] bool blocks(Index ear, Index corner) const;
  [[nodiscard]] int side(Index a, Index b, Index c) const;
  void update(Index corner);
  Index first_flat() const;

  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  std::span<const Point2> polygon_;
  std::vector<Index> previous_, next_; ///< among the corners left
  std::vector<int> turn_;              ///< 1 left, 0 straight on or back, -1 right; kRemoved
  std::vector<Index> hollow_;          ///< corners that do not turn left, and some that no longer matter
  std::vector<Index> waiting_;         ///< corners to look at next
};

} // namespace dirichlet
