// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "corner_tree.h"
#include "dirichlet/array.h"

namespace dirichlet {

/// Cuts polygons into triangles ear by ear; keeps its memory from one to the next.
///
/// An ear is a corner that turns left and whose open triangle no side of the polygon enters. Cutting one off leaves a
/// polygon of the same kind, even where sides touch or run back along each other, as in a keyhole. A corner on a
/// straight line (as near as rounding can tell) is cut off only when there is no ear, so that flat triangles appear
/// only where the polygon itself is flat.
class EarClipper {
 public:
  /// \param polygon   counter-clockwise
  /// \param rounding  how far its coordinates may be from what was meant
  /// \param triangles receives the corners' places in `polygon`, three for each of the size - 2 triangles.
  /// \returns false if no ear is left before the end, which is when the polygon crosses itself.
  bool cut(std::span<const Point2> polygon, double rounding, std::vector<Index>& triangles);

 private:
  void start(std::span<const Point2> polygon);
  void cut_ears(std::vector<Index>& triangles);
  void remove(Index corner, std::vector<Index>& triangles);
  [[nodiscard]] bool is_ear(Index corner) const;
  [[nodiscard]] bool blocks(Index ear, Index corner) const;
  [[nodiscard]] int side(Index a, Index b, Index c) const;
  void update(Index corner);
  [[nodiscard]] Index first_flat() const;

  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  std::span<const Point2> polygon_;
  double rounding_ = 0;
  std::size_t left_ = 0; ///< corners not yet cut off
  int round_ = 0;
  std::vector<Index> previous_, next_; ///< among the corners left
  std::vector<int> turn_;              ///< 1 left, 0 straight on or back, -1 right; kRemoved
  std::vector<int> touched_;           ///< the round in which a neighbour was last cut off
  CornerTree hollow_;                  ///< marked: corners that do not turn left (reflex, or straight)
  std::vector<Index> waiting_, now_;   ///< corners to look at in the next round, and in this one
};

} // namespace dirichlet
