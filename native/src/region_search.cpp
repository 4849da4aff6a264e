// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_search.h"

#include "parallel.h"

namespace dirichlet {

RegionSearch::RegionSearch(const SparseView& K, const Mask& mask)
    : K_(K), mask_(mask), search_(in_background(mask.size(), [this] { return free_regions(K_, mask_); })) {}

const FreeRegions& RegionSearch::result() {
  const std::scoped_lock lock(mutex_);
  if (search_.valid())
    regions_ = search_.get();
  else if (regions_.label.size() != mask_.size())
    regions_ = free_regions(K_, mask_);
  return regions_;
}

} // namespace dirichlet
