// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "graph.h"

namespace dirichlet::ordering {

/// Arrays that coarsenings use one after the other.
struct CoarseningScratch {
  Scratch<Index> slot;
  Scratch<Index> member_offsets, members; ///< the finer vertices of each coarse one
};

/// Gathers vertices with all their neighbours, in meshes about eight, and joins each gathering into one vertex: quick,
/// for large graphs. Cost: O(vertices + edges).
void coarsen(const Graph& fine, CoarseningScratch& scratch, CoarseGraph& coarse);

/// Joins pairs of vertices that share the heaviest edges (Karypis & Kumar 1998): slower, but keeps more of the shape.
/// \param variant different numbers, from 0 on, give different pairs. Cost: O(vertices + edges).
void coarsen(const WeightedGraph& fine, Index variant, CoarseningScratch& scratch, CoarseGraph& coarse);

} // namespace dirichlet::ordering
