// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace dirichlet {

/// Wall time since it was made or last asked to restart.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  /// The seconds so far; counts from 0 again.
  double restart() {
    const double passed = seconds();
    start_ = Clock::now();
    return passed;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

} // namespace dirichlet
