// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// What is legal in a mesh but seldom meant. A field is solved all the same; who asks for it should hear of this.
struct Defects {
  Index repeated_faces = 0;            ///< round the same vertices as an earlier face: count once
  std::array<Index, 2> first_repeat{}; ///< the lowest of them, and the face it repeats
  Index flat_faces = 0;                ///< faces without an area, see Mesh::flat_faces
  Index first_flat = 0;                ///< the lowest of them
  Index crossing_faces = 0;      ///< faces that cross themselves and are split all the same, see find_crossing_faces
  Index first_crossing = 0;      ///< the lowest of them
  Index coincident_vertices = 0; ///< vertices exactly where an earlier one is, both on a border or on two pieces, and
                                 ///< to which no edges without length join them
  std::array<Index, 2> first_coincident{}; ///< the lowest of them, after the one it coincides with

  [[nodiscard]] std::vector<std::string> warnings() const; ///< one sentence for each kind that there is
};

/// Cost: O(V + C), on all cores; another O(V) where there are borders or several pieces.
Defects find_defects(const Mesh& mesh);

/// The same for who has the pieces already. \param pieces  mesh.components()
Defects find_defects(const Mesh& mesh, const Components& pieces);

} // namespace dirichlet
