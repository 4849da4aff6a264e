// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <mutex>

#include "dirichlet/injection.h"

namespace dirichlet {

/// Finds the regions of the free rows on another core, while the system is factored and solved: they are needed last,
/// and with a source not at all. What begins another search, or ends, waits for the one that runs.
class RegionSearch {
 public:
  /// \param K  whose arrays outlive the search
  RegionSearch(const SparseView& K, const Mask& mask);

  /// Waits. A search that was denied memory is done again by who asks next. May be called from several threads.
  /// \throws std::bad_alloc  not enough memory
  const FreeRegions& result();

 private:
  SparseView K_;
  Mask mask_;
  std::mutex mutex_;
  FreeRegions regions_;
  std::future<FreeRegions> search_; ///< last, so that it ends before the rest goes
};

} // namespace dirichlet
