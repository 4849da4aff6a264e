// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/array.h"
#include "dirichlet/buffer.h"

namespace dirichlet {

/// Splits every polygon into triangles that lie inside it, over the same vertices and with its orientation.
///
/// A quad is split from its first to its third corner, unless that diagonal would fold it (a concave quad): then from
/// the second to the fourth; one bent out of its plane is split all the same. Larger polygons are cut ear by ear in the
/// plane of their area vector or, where its parts cancel or that fails, of their widest triangle; one thinner than 1e-5
/// of its size for which both fail, as a line in single precision may be, becomes a fan.
///
/// \param positions  (V, 3) finite
/// \param offsets    (F + 1,) and \param corners (C,): faces, each vertex at most once in a face.
/// \param left_out   faces that were there before, ascending: errors number faces as if they still were.
/// \returns (T, 3) triangles, T = C - 2 F, those of face 0 first.
/// \throws TopologyError  a polygon of more than four corners, not so thin, that crosses itself; names the face
/// Cost: O(C), for a polygon of k > 4 corners O(k²) at worst.
std::vector<Index> triangulate(std::span<const double> positions, std::span<const Index> offsets,
                               std::span<const Index> corners, std::span<const Index> left_out = {});

/// Quads two of whose sides cross, or pass each other so closely that they seem to, and larger polygons of which that
/// is why they become a fan: ascending. They are split all the same, as one that is twisted is no better and often
/// meant; but their triangles lie on each other. Flat faces are none of them. Cost: O(C), on all cores.
Buffer<Index> find_crossing_faces(std::span<const double> positions, std::span<const Index> offsets,
                                  std::span<const Index> corners);

} // namespace dirichlet
