// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace dirichlet {

/// The most threads that a piece of work is shared out to, beside which one more may search in the background; 0 for as
/// many as there are cores. With 1, a call stays in its caller's thread. For tests, and hosts that want a core left.
inline std::atomic<unsigned> thread_limit{0};

inline std::size_t core_count() {
  static const unsigned cores = std::max(1U, std::thread::hardware_concurrency()); // asked once: it reads files
  const unsigned limit = thread_limit.load(std::memory_order_relaxed);
  return limit == 0 ? cores : std::min(limit, cores);
}

/// Calls f(begin, end) for consecutive pieces of [0, count), each on a core of its own; a piece has at least `grain`
/// items, so that small work stays in the caller's thread. Returns when all are done, and rethrows the exception of the
/// first piece that threw one.
template <class F>
void parallel_chunks(std::size_t count, std::size_t grain, const F& f) {
  const std::size_t pieces = std::clamp<std::size_t>(count / std::max<std::size_t>(1, grain), 1, core_count());
  const auto start = [=](std::size_t piece) { return count / pieces * piece + std::min(piece, count % pieces); };
  std::vector<std::future<void>> others; // leaving this scope waits for them, whichever way it is left
  others.reserve(pieces - 1);
  // "deferred": where the system has no thread to give, the piece runs at get().
  constexpr auto policy = std::launch::async | std::launch::deferred;
  for (std::size_t k = 1; k < pieces; ++k) others.push_back(std::async(policy, std::cref(f), start(k), start(k + 1)));
  f(std::size_t{0}, start(1));
  for (auto& other : others) other.get();
}

/// f() beside what the caller does until it asks for the result; not before then where there is one core, or where so
/// few items are done before another thread has started.
template <class F>
auto in_background(std::size_t items, const F& f) {
  constexpr std::size_t kWorthThread = 1 << 12;
  const bool alone = core_count() == 1 || items < kWorthThread;
  return std::async(alone ? std::launch::deferred : std::launch::async | std::launch::deferred, f);
}

} // namespace dirichlet
