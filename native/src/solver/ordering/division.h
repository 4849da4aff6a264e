// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "graph.h"

namespace dirichlet::ordering {

enum Part : std::uint8_t { kLeft = 0, kRight = 1, kSeparator = 2 };

/// What makes one division better than another: less between the sides, and sides of about the same weight, since what
/// an uneven division leaves whole must be cut again (found by experiment: twice the square of the tilt).
inline double division_score(Index between, Index left, Index right) {
  const double tilt = (static_cast<double>(left) - right) / (2 * (static_cast<double>(left) + right));
  return between * (1 + 2 * tilt * tilt);
}

/// A graph in two sides, and later a separator between them.
struct Division {
  Scratch<std::uint8_t> part;    ///< of every vertex
  std::array<Index, 2> weight{}; ///< of the sides
  Index cut = 0;                 ///< weight of the edges between the sides
  std::vector<Index> boundary;   ///< the ends of these edges, and perhaps others

  [[nodiscard]] double score() const { return division_score(cut, weight[kLeft], weight[kRight]); }
};

} // namespace dirichlet::ordering
