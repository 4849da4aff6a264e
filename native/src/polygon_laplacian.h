// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dirichlet/laplacian.h"
#include "flat_faces.h"

namespace dirichlet {

/// The polygon Laplacian of Bunge, Herholz, Kazhdan and Botsch (2020).
struct PolygonLaplacian {
  SparseMatrix K;
  std::vector<double> mass; ///< (V,)
  FlatFaces flat;           ///< all of whose triangles around the virtual vertex are
};

/// The virtual vertex is where the squared areas of the triangles around it have the least sum; its weights are affine
/// and of the least norm. A direction in which a polygon is thinner than 1e-5 of its size does not count: a polygon on
/// a line has its virtual vertex at its mean.
///
/// Masses are those of the triangles, lumped; where the virtual vertex sees a side from behind, its triangle counts
/// negative, so that the sum stays the area; where that or a negative weight would leave a corner with a negative mass,
/// the polygon's area (of its area vector at least) is shared out in proportion to the triangles around.
/// \throws InputError  polygons of too many corners for 32-bit entries. Cost: O(V + sum of k²), on all cores.
PolygonLaplacian polygon_laplacian(const Mesh& mesh);

} // namespace dirichlet
