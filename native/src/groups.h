// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "index.h"

namespace dirichlet {

/// Things sorted into groups: group g is members[offsets[g]] … members[offsets[g + 1] - 1], ascending.
struct Groups {
  std::vector<std::size_t> offsets;
  std::vector<Index> members;

  /// Sorts 0 … group_of.size() - 1 by their group.
  Groups(std::size_t group_count, std::span<const Index> group_of)
      : offsets(group_count + 1), members(group_of.size()) {
    for (const Index g : group_of) ++offsets[at(g) + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
    for (std::size_t i = 0; i < group_of.size(); ++i) members[next[at(group_of[i])]++] = static_cast<Index>(i);
  }

  [[nodiscard]] std::span<const Index> operator[](Index g) const {
    return std::span(members).subspan(offsets[at(g)], offsets[at(g) + 1] - offsets[at(g)]);
  }
};

} // namespace dirichlet
