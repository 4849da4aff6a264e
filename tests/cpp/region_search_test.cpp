// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_search.h"

#include <new>
#include <optional>

#include <gtest/gtest.h>

#include "denied_memory.h"
#include "mesh_makers.h"

namespace dirichlet {
namespace {

using makers::make_mesh;

/// A square surface, large enough to be worth another thread, cut in two by a painted column.
struct Cut {
  static constexpr Index kSide = 80;
  SparseMatrix K = graph_stiffness(*make_mesh(makers::grid(kSide - 1, kSide - 1, false)));
  Mask mask = Mask(static_cast<std::size_t>(kSide * kSide), 0);
  Cut() {
    for (std::size_t v = 0; v < mask.size(); ++v) mask[v] = v % kSide == kSide / 2 ? 1 : 0;
  }
};

TEST(RegionSearch, finds_what_the_search_in_the_foreground_finds) {
  const Cut cut;
  RegionSearch search(cut.K, cut.mask);
  EXPECT_EQ(search.result().count, 2);
  EXPECT_EQ(search.result().label, free_regions(cut.K, cut.mask).label);
}

TEST(RegionSearch, that_was_denied_memory_says_so_and_is_done_again_by_who_asks_next) {
  const Cut cut;
  std::optional<RegionSearch> search;
  {
    // The search's own requests, whichever thread makes them, come after those of starting it.
    std::int64_t granted = 0;
    for (bool started = false; !started; ++granted) {
      const DeniedMemory deny(granted, DeniedMemory::kAll);
      try {
        search.emplace(cut.K, cut.mask);
        started = true;
        EXPECT_THROW(search->result(), std::bad_alloc);
      } catch (const std::bad_alloc&) {
        search.reset();
      }
    }
  }
  EXPECT_EQ(search->result().count, 2);
}

} // namespace
} // namespace dirichlet
