// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "dirichlet/array.h"
#include "vector3.h"

namespace dirichlet {

/// What finite elements know of a triangle.
struct TriangleShape {
  std::array<double, 3> cotangents{}; ///< of the angle at every corner
  double area = 0;                    ///< in the square of the coordinates' unit
};

/// The least height of a triangle over its longest edge, relative to that: far above the rounding of a double, and far
/// below what is meant by a height.
constexpr double kLeastHeight = 0x1p-44;

/// That of one whose height stands over the middle; over other places it lies between. Such have a cotangent of about
/// minus the inverse, beside which a sum keeps as many digits as thickening moves: half of them.
constexpr double kLeastCap = 0x1p-26;

/// Cotangents by the cross product of the two shorter edges, which keeps needles and caps exact; a lower triangle is
/// given the least height above the foot that it has. Of coordinates only differences count, at any scale.
TriangleShape triangle_shape(const std::array<Vector3, 3>& corners);

inline Vector3 point(std::span<const double> positions, Index vertex) {
  const double* p = positions.data() + 3 * static_cast<std::size_t>(vertex);
  return {p[0], p[1], p[2]};
}

} // namespace dirichlet
