// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace dirichlet {

/// The lengths of a triangle's sides: side i runs from corner i to the next, opposite to the corner before.
using Sides = std::array<double, 3>;

/// ½ cot of the angle opposite to each side, of any scale; above 0 for all but the longest. By Heron's formula in
/// Kahan's order ("Miscalculating Area and Angles of a Needle-like Triangle", 2014): as exact as lengths can tell.
/// Infinite or NaN where the area is 0: see mollified_sides in side_lengths.h.
Sides half_cotangents(const Sides& sides);

} // namespace dirichlet
