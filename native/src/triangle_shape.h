// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>

#include "dirichlet/array.h"
#include "vector3.h"

namespace dirichlet {

/// What finite elements know of a triangle.
struct TriangleShape {
  std::array<double, 3> cotangents{}; ///< of the angle at every corner
  double area = 0;                    ///< in the square of the coordinates' unit
  bool flat = false;                  ///< no area, as far as its rounded coordinates can tell
};

/// The least height of a triangle over its longest edge, relative to that. A cotangent is at most the inverse of it:
/// the square root of what a double resolves, so that what thickening moves is no more than what rounding would drown.
constexpr double kLeastHeight = 0x1p-26;

/// Cotangents by the cross product of the two shorter edges, which keeps needles and caps exact; a lower triangle is
/// given the least height above the foot that it has. Of coordinates only differences count, at any scale.
/// \param rounding  how far the coordinates may be from what was meant
TriangleShape triangle_shape(const std::array<Vector3, 3>& corners, double rounding);

inline Vector3 point(std::span<const double> positions, Index vertex) {
  const double* p = positions.data() + 3 * static_cast<std::size_t>(vertex);
  return {p[0], p[1], p[2]};
}

/// How far a coordinate of this size may be from what was meant.
inline double rounding_of(double largest_coordinate) {
  return 4 * std::numeric_limits<double>::epsilon() * largest_coordinate;
}

} // namespace dirichlet
