// SPDX-License-Identifier: GPL-3.0-or-later
#include "maximum_principle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include "index.h"
#include "parallel.h"

namespace dirichlet {

Projection project_onto_painted_range(const FreeRegions& regions, Column values) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> range(at(regions.count), {kInfinity, -kInfinity});
  for (const auto& [region, row] : regions.rim) {
    auto& [low, high] = range[at(region)];
    low = std::min(low, values[row]);
    high = std::max(high, values[row]);
  }
  Projection all;
  std::mutex mutex;
  parallel_chunks(regions.label.size(), 1 << 15, [&](std::size_t begin, std::size_t end) {
    Projection mine;
    for (std::size_t i = begin; i < end; ++i) {
      const Index region = regions.label[i];
      if (region == FreeRegions::kPainted) continue;
      const auto& [low, high] = range[at(region)];
      if (low > high) continue;
      double& value = values[static_cast<Eigen::Index>(i)];
      const double inside = std::clamp(value, low, high);
      if (inside == value) continue;
      ++mine.count;
      mine.farthest = std::max(mine.farthest, std::abs(value - inside));
      value = inside;
    }
    const std::scoped_lock lock(mutex);
    all.count += mine.count;
    all.farthest = std::max(all.farthest, mine.farthest);
  });
  return all;
}

} // namespace dirichlet
