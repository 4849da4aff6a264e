// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// What a painted patch is, as facts; nothing here is refused. The patch is the part of the mesh spanned by its
/// vertices: their edges, and the faces all of whose corners are painted.
struct PatchFacts {
  Index vertices = 0;
  Index edges = 0;
  Index faces = 0;
  Index components = 0;           ///< connected pieces
  Index euler_characteristic = 0; ///< vertices - edges + faces
  Index border_loops = 0;         ///< of the faces; 0 when they are not manifold
  bool manifold = false;          ///< there are faces, and they form an orientable surface with or without border
  bool disc = false;              ///< manifold, connected, Euler characteristic 1, one border loop, no loose edge
  std::vector<Index> overlaps;    ///< the other patches that share a vertex with it, ascending
};

/// \param patches  vertex indices of every patch, any order, repeats counted once.
/// \throws InputError  an index out of range; names the patch and the index.
/// Cost: O(V + sum of the patches and their one-rings), the half-edge structure of a patch by OpenMesh.
std::vector<PatchFacts> inspect_patches(const Mesh& mesh, std::span<const std::vector<Index>> patches);

} // namespace dirichlet
