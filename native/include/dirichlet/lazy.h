// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>

namespace dirichlet {

/// A value made when it is first asked for, and kept; several threads may ask at once.
template <class T>
class Lazy {
 public:
  /// \param make  without arguments, the value; one that throws is called again by who asks next.
  template <class Make>
  const T& get(const Make& make) const {
    if (!made_.load(std::memory_order_acquire)) {
      const std::lock_guard lock(mutex_); // no std::call_once: where its function throws, some libraries hang
      if (!made_.load(std::memory_order_relaxed)) {
        value_ = make();
        made_.store(true, std::memory_order_release);
      }
    }
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::atomic<bool> made_{false};
  mutable T value_{};
};

} // namespace dirichlet
