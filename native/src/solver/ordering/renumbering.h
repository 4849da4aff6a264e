// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/buffer.h"
#include "graph.h"

namespace dirichlet::ordering {

/// A graph numbered so that neighbours are close in memory.
struct Renumbered {
  Buffer<Index> vertices; ///< their numbers in the graph that came in
  std::vector<Index> offsets;
  Buffer<Index> neighbours;
  std::vector<Index> hubs; ///< left out: vertices with so many neighbours that they hide the structure of the rest

  [[nodiscard]] Graph graph() const { return {static_cast<Index>(vertices.size()), offsets.data(), neighbours.data()}; }
};

/// Numbers the vertices breadth first (after Cuthill & McKee 1969), without diagonal entries and hubs.
Renumbered renumber(std::span<const Index> offsets, std::span<const Index> neighbours, unsigned threads);

} // namespace dirichlet::ordering
