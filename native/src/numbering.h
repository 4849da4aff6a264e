// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "index.h"

namespace dirichlet {

/// Numbers what it is asked for 0, 1, 2 … in the order of first sight, so that work on a small part of something large
/// needs arrays of that part's size. Open addressing in a table at most half full.
class Numbering {
 public:
  /// The number of an item >= 0.
  Index operator()(Index item) {
    if (2 * items_.size() >= slots_.size()) grow();
    Index& slot = slot_of(item);
    if (slot == kFree) {
      slot = static_cast<Index>(items_.size());
      items_.push_back(item);
    }
    return slot;
  }

  [[nodiscard]] const std::vector<Index>& items() const { return items_; } ///< by number

 private:
  static constexpr Index kFree = -1;

  /// Where the item is, or would be.
  Index& slot_of(Index item) {
    const std::size_t last = slots_.size() - 1;
    std::size_t place = (static_cast<std::uint64_t>(item) * 0x9E3779B97F4A7C15U >> 20U) & last; // Fibonacci hashing
    while (slots_[place] != kFree && items_[at(slots_[place])] != item) place = (place + 1) & last;
    return slots_[place];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t number = 0; number < items_.size(); ++number) slot_of(items_[number]) = static_cast<Index>(number);
  }

  std::vector<Index> items_;
  std::vector<Index> slots_ = std::vector<Index>(32, kFree); ///< a power of two many; numbers of items
};

} // namespace dirichlet
