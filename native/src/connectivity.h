// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// Edges, and which half-edges share one. Half-edges are counting-sorted by their smaller vertex, then the few of one
/// vertex by their larger. Cost: O(V + C), for a vertex of k > 24 edges O(k log k).
Connectivity build_connectivity(Index vertex_count, std::span<const Index> offsets, std::span<const Index> corners);

/// Border half-edges joined end to end by turning around the vertex between them through its faces: sheets that touch
/// in a vertex keep a loop each. A chain cut by a non-manifold edge does not close and is left out.
BorderLoops trace_border_loops(std::span<const Index> offsets, std::span<const Index> corners,
                               const Connectivity& connectivity);

} // namespace dirichlet
