// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

/// Splits every polygon into triangles that lie inside it, over the same vertices and with its orientation.
///
/// A quad is split from its first to its third corner, unless that diagonal would fold it (a concave quad): then from
/// the second to the fourth. Larger polygons are cut ear by ear in the plane of their area vector; one whose area
/// vector is zero lies in no plane and becomes a fan.
///
/// \param positions  (V, 3) finite
/// \param offsets    (F + 1,) and \param corners (C,): faces, each vertex at most once in a face.
/// \returns (T, 3) triangles, T = C - 2 F, those of face 0 first.
/// \throws TopologyError  a polygon of more than four corners with no ear, i.e. one that crosses itself; names the face
/// Cost: O(C), for a polygon of k > 4 corners O(k²) at worst.
std::vector<Index> triangulate(std::span<const double> positions, std::span<const Index> offsets,
                               std::span<const Index> corners);

} // namespace dirichlet
