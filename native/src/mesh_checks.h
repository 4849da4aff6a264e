// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "dirichlet/array.h"

namespace dirichlet {

/// Corners and matrix entries are counted in 32 bits; a corner makes at most two entries.
constexpr std::size_t kMostCorners = std::numeric_limits<Index>::max() / 4;

/// Finite, and so that squares are: at most 1e150.
bool is_coordinate(double x);

/// (V, 3) such coordinates. Each throws an InputError that names the first offender and how many more.
void check_positions(std::span<const double> positions);

/// From 0 to the number of corners, ascending.
void check_offsets(std::span<const Index> offsets, std::size_t corner_count);

/// In [0, vertex_count). \param offsets  checked
void check_corner_range(std::span<const Index> offsets, std::span<const Index> corners, Index vertex_count);

} // namespace dirichlet
