// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// The stiffness matrix of weighted edges: K(i,j) = −Σ weights of the edges (i,j), K(i,i) = Σ weights of all edges at
/// i.
///
/// \param edges    (E, 2) vertices in [0, n), in any order and direction. The weights of an edge that comes several
/// times
///                 are added in the order given; one from a vertex to itself gives nothing.
/// \param weights  (E,) finite
/// \returns  n × n, symmetric bit for bit, columns ascending; the diagonal is stored for every vertex, and so is a 0.
/// Cost: O(V + E), for a vertex of k > 24 edges O(k log k); all cores on large input. Same bits whatever the thread
/// count.
SparseMatrix stiffness_of_edges(Index n, std::span<const Index> edges, std::span<const double> weights);

} // namespace dirichlet
