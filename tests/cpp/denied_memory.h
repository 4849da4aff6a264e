// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace dirichlet {

/// While it lives, `new` grants so many requests and then denies the given number of them, in any thread. One at a
/// time.
class DeniedMemory {
 public:
  static constexpr std::int64_t kAll = INT64_MAX / 2;

  explicit DeniedMemory(std::int64_t granted, std::int64_t denied = 1);
  ~DeniedMemory();
  DeniedMemory(const DeniedMemory&) = delete;
  DeniedMemory& operator=(const DeniedMemory&) = delete;

  /// Whether there were so many requests that one was denied.
  [[nodiscard]] static bool happened();
};

/// By `new`, in all threads, since the program started.
std::int64_t bytes_asked_for();

} // namespace dirichlet
