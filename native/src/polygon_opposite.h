// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/mesh.h"

namespace dirichlet {

/// The other half-edge, in mesh.triangulated(), of the polygon side or diagonal that `half_edge` is part of; or kBorder
/// or kNonManifold. The triangulated mesh cannot tell where a diagonal joins the same two vertices as an edge or as
/// another diagonal (two quads that share three vertices): it sees one edge with many triangles.
/// Cost: O(log F + triangles at the vertex that has fewer); at the first call O(V + C), see Mesh::corners_by_vertex.
Index opposite_in_polygons(const Mesh& mesh, Index half_edge);

} // namespace dirichlet
