// SPDX-License-Identifier: GPL-3.0-or-later
#include "maximum_principle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dirichlet {

PaintedRanges::PaintedRanges(const FreeRegions& regions, const Block& field)
    : regions_(regions), columns_(static_cast<std::size_t>(field.cols())) {
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

double PaintedRanges::move(double value, double low, double high, Projection& moved) {
  const double inside = std::clamp(value, low, high);
  ++moved.count;
  moved.farthest = std::max(moved.farthest, std::abs(value - inside));
  return inside;
}

} // namespace dirichlet
