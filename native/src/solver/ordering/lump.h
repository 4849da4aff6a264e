// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "graph.h"

namespace dirichlet::ordering {

/// An approximate minimum degree order (Amestoy, Davis & Duff 1996) of a graph that dissection does not help: order[k]
/// is the vertex eliminated k-th. Rows may hold their vertex itself.
std::vector<Index> order_lump(const Graph& graph);

} // namespace dirichlet::ordering
