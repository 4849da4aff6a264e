// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "graph.h"

namespace dirichlet::ordering {

/// Writes an approximate minimum degree order (Amestoy, Davis & Duff 1996) of a graph that dissection does not help:
/// order[k] is the vertex eliminated k-th.
void order_lump(const Graph& graph, Index* order);

} // namespace dirichlet::ordering
