// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// A point of the surface as weights on the corners of a triangle; >= 0, sum 1.
struct SurfacePoint {
  std::array<Index, 3> vertices{};
  std::array<double, 3> weights{};
};

/// The point of `triangles` nearest to `point`; of equally near ones, that in the first triangle. Triangles without an
/// area count as the segments or points that they are. Cost: O(T).
SurfacePoint closest_point(const Mesh& triangles, const std::array<double, 3>& point);

/// The same among the triangles first … last - 1 alone, at least one. Cost: O(last - first).
SurfacePoint closest_point(const Mesh& triangles, const std::array<double, 3>& point, Index first, Index last);

} // namespace dirichlet
