// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/array.h"
#include "dirichlet/buffer.h"

namespace dirichlet {

/// Whether no corner is farther than rounding from the line through the first and that farthest from it.
bool is_flat(std::span<const double> positions, std::span<const Index> face);

/// Those of a mesh: ascending.
/// Cost: O(C), on all cores.
Buffer<Index> find_flat_faces(std::span<const double> positions, std::span<const Index> offsets,
                              std::span<const Index> corners);

} // namespace dirichlet
