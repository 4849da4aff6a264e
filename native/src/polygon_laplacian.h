// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// The polygon Laplacian of Bunge, Herholz, Kazhdan and Botsch (2020).
struct PolygonLaplacian {
  SparseMatrix K;
  std::vector<double> mass; ///< (V,)
};

/// The virtual vertex is where the squared areas of the triangles around it have the least sum; its weights are affine
/// and of the least norm. A direction in which a polygon is thinner than 1e-5 of its size does not count: a polygon on
/// a line has its virtual vertex at its mean.
///
/// Masses are those of the triangles, lumped; where the virtual vertex sees a side from behind, its triangle counts
/// negative, so that the sum stays the area; where that or a negative weight would leave a corner with a negative mass,
/// the polygon's area (of its area vector at least) is shared out in proportion to the triangles around.
/// \throws InputError  a polygon of more than 7000 corners: all are joined to all, so that a direct solver takes time
/// as their cube, some ten seconds there; or more pairs of corners than fit the memory at 72 bytes each (a polygon of
/// 5000 takes .9 GB), or than 2^29. Cost: O(V + sum of k²), on all cores.
PolygonLaplacian polygon_laplacian(const Mesh& mesh);

} // namespace dirichlet
