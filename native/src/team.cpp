// SPDX-License-Identifier: GPL-3.0-or-later
#include "team.h"

#include <utility>

namespace dirichlet {

Team::Team(std::size_t threads) {
  try {
    for (std::size_t k = 1; k < threads; ++k) helpers_.emplace_back([this] { help(); });
  } catch (const std::exception&) {
    return; // no thread, or no memory for one: those that are there do the work
  }
}

Team::~Team() {
  {
    const std::scoped_lock lock(mutex_);
    closing_ = true;
  }
  work_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Team::help() {
  std::unique_lock lock(mutex_);
  while (true) {
    work_.wait(lock, [this] { return closing_ || next_ < count_; });
    if (closing_) return;
    run_next(lock);
    if (next_ == count_ && running_ == 0) done_.notify_one();
  }
}

/// One part, without the lock.
void Team::run_next(std::unique_lock<std::mutex>& lock) {
  const Index part = next_++;
  ++running_;
  lock.unlock();
  std::exception_ptr error;
  try {
    (*job_)(part);
  } catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  --running_;
  if (error && (!error_ || part < failed_)) {
    failed_ = part;
    error_ = error;
  }
}

void Team::share_out(Index count, const std::function<void(Index)>& f) {
  if (helpers_.empty() || count <= 1) {
    for (Index part = 0; part < count; ++part) f(part);
    return;
  }
  std::unique_lock lock(mutex_);
  job_ = &f;
  next_ = 0;
  count_ = count;
  work_.notify_all();
  while (next_ < count_) run_next(lock);
  done_.wait(lock, [this] { return running_ == 0; });
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

} // namespace dirichlet
