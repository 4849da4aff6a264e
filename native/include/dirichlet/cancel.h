// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include "dirichlet/error.h"

namespace dirichlet {

/// A flag that asks work in another thread to stop. Copies share the flag, which stays raised until it is lowered: work
/// that begins meanwhile stops at once. May be used from any thread.
class CancelToken {
 public:
  CancelToken() : raised_(std::make_shared<std::atomic<bool>>(false)) {}

  void cancel() const { *raised_ = true; }
  void reset() const { *raised_ = false; }
  [[nodiscard]] bool is_cancelled() const { return raised_->load(std::memory_order_relaxed); }

  /// To be called by the work, often. \throws CancelledError  the flag is raised.
  void check() const {
    if (is_cancelled()) throw CancelledError("the work was cancelled");
  }

 private:
  std::shared_ptr<std::atomic<bool>> raised_;
};

} // namespace dirichlet
