// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

constexpr Index kUndefined = -1;

/// How many of the ascending levels are <= the value of every vertex; kUndefined where that is NaN.
/// Cost: O(V log K), on all cores.
std::vector<Index> level_numbers(std::span<const double> field, std::span<const double> levels);

} // namespace dirichlet
