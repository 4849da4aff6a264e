// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/cancel.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// What levels cut a surface into, to a scale: K levels. Triangles on which the field is constant do not count, no line
/// can divide them; nor do those with a NaN.
struct Strips {
  std::vector<double> area;   ///< (K,) where the field is below every level
  std::vector<double> before; ///< (K,) length of every level's lines, as the limit from below
  std::vector<double> after;  ///< (K,) and from above; they differ where a plateau begins or ends
};

/// \param triangles  a mesh of triangles
/// \param field      (V,) of no infinite value
/// \param levels     (K,) ascending
/// Cost: O(V log K + T + crossings of triangles and levels). Same result whatever the thread count.
Strips measure_strips(const Mesh& triangles, std::span<const double> field, std::span<const double> levels,
                      const CancelToken& cancel = {});

} // namespace dirichlet
