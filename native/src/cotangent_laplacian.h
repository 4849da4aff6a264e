// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// Measures of the triangles of mesh.triangulated().without_repeats(), which the intrinsic Delaunay Laplacian keeps.
struct Cotangents {
  Buffer<double> weights;   ///< (C,) half the cotangent of the angle opposite to every half-edge
  std::vector<double> mass; ///< (V,) a third of the areas around
};

/// Cost: O(V + C), on all cores. \throws TopologyError  a polygon without a triangulation
Cotangents measure_cotangents(const Mesh& mesh);

/// Every half-edge adds its weight to its edge, however many share it.
SparseMatrix cotangent_stiffness(const Mesh& mesh, std::span<const double> weights);

} // namespace dirichlet
