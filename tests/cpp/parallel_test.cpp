// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../native/src/parallel.h"

#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dirichlet {
namespace {

TEST(ParallelChunks, visit_every_item_once) {
  for (const std::size_t count : {0U, 1U, 7U, 1000U, 1001U}) {
    std::vector<int> visits(count, 0);
    parallel_chunks(count, 3, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

TEST(ParallelChunks, hand_the_caller_an_error_of_any_piece) {
  const auto fail_at = [](std::size_t place) {
    parallel_chunks(1000, 1, [=](std::size_t begin, std::size_t end) {
      if (begin <= place && place < end) throw std::out_of_range("stop");
    });
  };
  EXPECT_THROW(fail_at(0), std::out_of_range);
  EXPECT_THROW(fail_at(999), std::out_of_range);
}

TEST(ParallelChunks, keep_small_work_in_the_callers_thread) {
  const auto caller = std::this_thread::get_id();
  parallel_chunks(19, 10, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(end - begin, 19U);
  });
}

TEST(InBackground, small_work_or_one_thread_waits_for_the_caller) {
  const auto caller = std::this_thread::get_id();
  const auto whoami = [] { return std::this_thread::get_id(); };
  EXPECT_EQ(in_background(100, whoami).get(), caller);
  thread_limit = 1;
  EXPECT_EQ(in_background(1'000'000, whoami).get(), caller);
  thread_limit = 0;
}

} // namespace
} // namespace dirichlet
