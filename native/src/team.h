// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

/// The caller and some threads that wait at its side, for work that falls into many small parts: waking a thread is
/// quicker than starting one. They live as long as the team does, so none is left behind when a call returns.
class Team {
 public:
  /// \param threads  the caller included; there are fewer where the system has none to give.
  explicit Team(std::size_t threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Calls f(0) … f(count − 1), each as soon as a thread is free, and returns when all are done. Rethrows the exception
  /// of the lowest of those that threw one. Not to be called from within f.
  void share_out(Index count, const std::function<void(Index)>& f);

  [[nodiscard]] std::size_t size() const { return helpers_.size() + 1; }

 private:
  void help();
  void run_next(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable work_, done_;
  const std::function<void(Index)>* job_ = nullptr;
  Index next_ = 0, count_ = 0, running_ = 0; ///< parts: the next to begin, all, those that somebody works on
  Index failed_ = 0;                         ///< the lowest that threw, if there is an error
  std::exception_ptr error_;
  bool closing_ = false;
  std::vector<std::thread> helpers_;
};

} // namespace dirichlet
