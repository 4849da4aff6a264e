// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_search.h"

#include <utility>

#include "parallel.h"

namespace dirichlet {

RegionSearch::RegionSearch(const SparseView& K, const Mask& mask) : K_(K), mask_(mask) {
  constexpr std::size_t kWorthThread = 1 << 12; // rows; fewer are searched before another thread has started
  const bool alone = core_count() == 1 || mask_.size() < kWorthThread;
  const auto policy = alone ? std::launch::deferred : std::launch::async | std::launch::deferred;
  search_ = std::async(policy, [this] { return free_regions(K_, mask_); });
}

const FreeRegions& RegionSearch::result() {
  const std::scoped_lock lock(mutex_);
  if (search_.valid())
    regions_ = search_.get();
  else if (regions_.label.size() != mask_.size())
    regions_ = free_regions(K_, mask_);
  return regions_;
}

} // namespace dirichlet
