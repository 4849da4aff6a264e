// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/laplacian.h"

namespace dirichlet {

/// The stiffness matrix of linear finite elements on an intrinsic Delaunay triangulation of the surface, over the
/// mesh's own vertices: K(i,j) = −Σ ½ (cot α + cot β). Symmetric, rows sum to 0, and every weight is ≥ 0 on every mesh,
/// so that min b ≤ φ ≤ max b; what a face connects, positive weights connect.
///
/// Flips leave the surface and its vertices as they are. Where faces do not make one sheet with a direction all around,
/// they count front and back, half each (see intrinsic/cover.h). A border edge stays; its weight would be negative
/// opposite to an obtuse angle and is then so little that no field shows it: the rows of all other vertices stay those
/// of finite elements, hence linear functions exact in a plane with a painted border.
///
/// \param mesh             triangles
/// \param half_cotangents  (C,) theirs: see Cotangents
/// \param notes            become what Stiffness tells of it
/// Cost: O(V + C + flips); all cores but for the flips. About 120 bytes per face and sheet beside the result.
///
/// Source: Bobenko, Springborn, "A Discrete Laplace–Beltrami Operator for Simplicial Surfaces", 2007; Sharp, Crane, "A
/// Laplacian for Nonmanifold Triangle Meshes", 2020.
SparseMatrix intrinsic_delaunay_stiffness(const Mesh& mesh, std::span<const double> half_cotangents,
                                          DelaunayNotes& notes);

} // namespace dirichlet
