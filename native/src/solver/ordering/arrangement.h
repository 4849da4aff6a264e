// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "region_tree.h"

namespace dirichlet::ordering {

/// The order of elimination of a graph whose divisions have their separators: a separator last, before it the branches
/// that it separates, one after the other, and the regions at their ends by minimum degree.
std::vector<Index> arrange(const Graph& graph, const RegionTree& tree, const Regions& regions, unsigned threads);

} // namespace dirichlet::ordering
