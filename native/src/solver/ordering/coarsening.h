// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "graph.h"

namespace dirichlet::ordering {

/// Gathers the vertices of `fine` into connected aggregates, in meshes of about eight, and joins each into one vertex.
/// Cost: O(vertices + edges), with two passes over the edges.
void coarsen(const Graph& fine, Scratch<Index>& scratch, CoarseGraph& coarse);
void coarsen(const CoarseGraph& fine, Scratch<Index>& scratch, CoarseGraph& coarse);

} // namespace dirichlet::ordering
