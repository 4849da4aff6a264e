// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "dirichlet/mesh.h"
#include "intrinsic/intrinsic_triangulation.h"

namespace dirichlet {

/// A mesh's triangles as one or two sheets that are surfaces with a direction all around.
struct Cover {
  IntrinsicTriangulation triangles;
  int sheets;      ///< how often it holds every face of the mesh
  Index thickened; ///< see SideLengths
};

/// Where every edge has at most two faces and the surface has a direction all around, its faces turned that way. Else
/// every face twice, front and back: what sees a side of it glued to what sees the same space between two neighbouring
/// faces of an edge, in the order of their dihedral angles. A border edge is glued to nothing. Of equal faces one
/// counts.
///
/// Independent of the direction and the order of the faces. Lengths are mollified where a triangle asks for it.
///
/// \param triangles        a mesh of triangles
/// \param half_cotangents  (C,) of the angle opposite to every half-edge: see Cotangents
/// Cost: O(C) on all cores; with k half-edges at edges of three or more faces O(C + k log k).
/// Source: Sharp, Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020, whose tufted cover also closes borders.
Cover cover(const Mesh& triangles, std::span<const double> half_cotangents);

} // namespace dirichlet
