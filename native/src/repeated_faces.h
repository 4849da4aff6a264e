// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// The faces that run round the same vertices as an earlier one, in either direction and from any corner, and the first
/// such face: pairs, ascending. Two faces that run in opposite directions and share all their sides with each other
/// alone are a closed pillow, in which none is repeated.
/// Cost: O(C); sorting, where many faces are repeated.
std::vector<std::array<Index, 2>> find_repeated_faces(std::span<const Index> offsets, std::span<const Index> corners,
                                                      const Connectivity& connectivity);

/// The number that a face had before some were left out, ascending.
Index number_among_all(Index face, std::span<const Index> left_out);

} // namespace dirichlet
