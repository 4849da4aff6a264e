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
  for (const auto& [region, row] : regions.rim) {
    auto* range = ranges_.data() + at(region) * columns_;
    for (const double value : field.row(row)) {
      auto& [low, high] = *range++;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
}

double PaintedRanges::move(double value, double low, double high, Outside& outside) const {
  const double inside = std::clamp(value, low, high);
  if (low == high) return inside;
  ++outside.count;
  outside.farthest = std::max(outside.farthest, std::abs(value - inside));
  return maximum_principle_ ? inside : value;
}

} // namespace dirichlet
