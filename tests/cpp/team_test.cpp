// SPDX-License-Identifier: GPL-3.0-or-later
#include "team.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace dirichlet {
namespace {

TEST(Team, of_any_size_does_every_part_once_as_often_as_it_is_asked) {
  for (const std::size_t threads : {0U, 1U, 2U, 5U}) {
    Team team(threads);
    for (Index count = 0; count < 200; ++count) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
      team.share_out(count, [&](Index part) { ++calls[static_cast<std::size_t>(part)]; });
      for (const auto& times : calls) EXPECT_EQ(times, 1);
    }
  }
}

TEST(Team, works_side_by_side) {
  Team team(2);
  ASSERT_EQ(team.size(), 2U);
  std::atomic<int> arrived{0};
  team.share_out(2, [&](Index) { // each waits for the other: one after the other would never end
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

TEST(Team, passes_on_the_lowest_exception_and_goes_on_working) {
  for (const std::size_t threads : {1U, 2U, 4U}) {
    Team team(threads);
    for (int round = 0; round < 50; ++round) {
      std::atomic<int> seen{0};
      try {
        team.share_out(9, [&](Index part) {
          ++seen;
          if (part >= 3) throw std::runtime_error(std::to_string(part));
        });
        FAIL() << "no exception";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "3");
      }
      EXPECT_GE(seen, 4);
      team.share_out(4, [&](Index) { ++seen; });
      EXPECT_GE(seen, 8);
    }
  }
}

} // namespace
} // namespace dirichlet
