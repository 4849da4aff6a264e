// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "dirichlet/array.h"
#include "triangle_shape.h"
#include "vector3.h"

namespace dirichlet {

/// What is thinner than this share of its size may be so by rounding alone where coordinates are in single precision.
constexpr double kThin = 1e-5;

/// How far a face reaches.
struct FaceExtent {
  Vector3 origin;      ///< its first corner
  Vector3 line;        ///< from there to the corner farthest away, by the greatest part
  double size = 0;     ///< that part
  double rounding = 0; ///< how far its coordinates may be from what was meant
};

inline FaceExtent face_extent(std::span<const double> positions, std::span<const Index> face) {
  FaceExtent extent;
  extent.origin = point(positions, face[0]);
  double largest = largest_part(extent.origin);
  for (const Index v : face.subspan(1)) {
    const Vector3 p = point(positions, v);
    largest = std::max(largest, largest_part(p));
    if (const double part = largest_part(p - extent.origin); part > extent.size) {
      extent.size = part;
      extent.line = p - extent.origin;
    }
  }
  extent.rounding = 4 * std::numeric_limits<double>::epsilon() * largest;
  return extent;
}

} // namespace dirichlet
