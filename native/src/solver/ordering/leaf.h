// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "graph.h"

namespace dirichlet::ordering {

constexpr Index kLargestLeaf = 320;

/// Orders `vertices`, at most kLargestLeaf, by exact minimum degree (Tinney & Walker 1967) and writes them to `order`.
/// Neighbours elsewhere count in the degrees and spread with the fill, as they are eliminated later; 128 of them count.
/// \param place of a vertex: position + i for vertices[i], nothing of the kind for others.
void order_leaf(const Graph& graph, std::span<const Index> vertices, const Index* place, Index position, Index* order);

} // namespace dirichlet::ordering
