// SPDX-License-Identifier: GPL-3.0-or-later
#include "maximum_principle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dirichlet {

PaintedRanges::PaintedRanges(const FreeRegions& regions, const Block& field, bool maximum_principle)
    : regions_(regions), columns_(static_cast<std::size_t>(field.cols())), maximum_principle_(maximum_principle) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ranges_.assign(at(regions.count) * columns_, {kInfinity, -kInfinity});
  all_.assign(columns_, {kInfinity, -kInfinity});
  for (const auto& [region, row] : regions.rim) {
    auto* range = ranges_.data() + at(region) * columns_;
    for (const double value : field.row(row)) {
      auto& [low, high] = *range++;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    auto& [low, high] = all_[i % columns_];
    low = std::min(low, ranges_[i][0]);
    high = std::max(high, ranges_[i][1]);
  }
}

double PaintedRanges::move(double value, double low, double high, Index column, Outside& outside) const {
  const double inside = std::clamp(value, low, high);
  if (low == high) return inside;
  constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon(); // of a mean, a few times over
  if (maximum_principle_ && std::abs(value - inside) <= kRounding * std::max(std::abs(low), std::abs(high)))
    return inside;
  ++outside.count;
  outside.farthest = std::max(outside.farthest, std::abs(value - inside));
  const auto& [least, greatest] = all_[at(column)];
  outside.share = std::max(outside.share, std::abs(value / 2 - inside / 2) / (greatest / 2 - least / 2)); // no overflow
  return maximum_principle_ ? inside : value;
}

} // namespace dirichlet
