// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "dirichlet/injection.h"
#include "index.h"

namespace dirichlet {

/// How many values lie outside the painted range of their region, and how far at most, also as a share of the range
/// painted at all rims in their column.
struct Outside {
  Index count = 0;
  double farthest = 0;
  double share = 0;
};

/// The maximum principle, region by region: no value leaves the range painted at the rim. Rounding may, by an ulp, and
/// an isoline at exactly that value would be noise; such values are moved to the end of the range, and counted if more
/// than the last digits are wrong. Regions without a rim have none, and stay.
///
/// An operator without that principle still gives the constant to a region whose rim is constant. Elsewhere values
/// outside are counted and stay where they are.
class PaintedRanges {
 public:
  /// \param field  (n, k), of which painted rows are read; regions are kept by reference. Cost: O(k rim).
  /// \param maximum_principle  whether the operator has one
  PaintedRanges(const FreeRegions& regions, const Block& field, bool maximum_principle);

  /// A value of the field, inside the range of its region as far as that rules; `outside` counts it if it was not.
  double hold(Index row, Index column, double value, Outside& outside) const {
    const Index region = regions_.label[at(row)];
    if (region == FreeRegions::kPainted) return value;
    const auto& [low, high] = ranges_[at(region) * columns_ + at(column)];
    if ((value >= low && value <= high) || low > high) return value;
    return move(value, low, high, column, outside);
  }

 private:
  [[nodiscard]] double move(double value, double low, double high, Index column, Outside& outside) const;

  const FreeRegions& regions_;
  std::size_t columns_;
  bool maximum_principle_;
  std::vector<std::array<double, 2>> ranges_; ///< (regions, k); lowest and highest
  std::vector<std::array<double, 2>> all_;    ///< (k,) the same of all regions
};

} // namespace dirichlet
