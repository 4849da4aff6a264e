// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dirichlet/cancel.h"
#include "graph.h"

namespace dirichlet::ordering {

/// Nested dissection: a separator last, before it what it separates, one part after the other, each in the same way
/// down to leaves of minimum degree. \returns the vertices in the order of their elimination.
std::vector<Index> dissect(const Graph& graph, unsigned threads, const CancelToken& cancel);

} // namespace dirichlet::ordering
