// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet::ordering {

// "deferred": where the system has no thread to give, the work is done at get().
constexpr auto kAnyThread = std::launch::async | std::launch::deferred;

/// Calls f(item, worker) for items 0 … count - 1, whoever of `workers` threads is free the next; worker 0 is the
/// caller's thread.
template <class F>
void share_out(Index count, unsigned workers, const F& f) {
  std::atomic<Index> next{0};
  const auto work = [&](unsigned worker) {
    for (Index k = next++; k < count; k = next++) f(k, worker);
  };
  std::vector<std::future<void>> others; // leaving this scope waits for them, whichever way it is left
  workers = std::min(workers, static_cast<unsigned>(count));
  for (unsigned w = 1; w < workers; ++w) others.push_back(std::async(kAnyThread, work, w));
  work(0);
  for (auto& other : others) other.get();
}

} // namespace dirichlet::ordering
