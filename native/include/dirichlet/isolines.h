// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dirichlet/buffer.h"
#include "dirichlet/cancel.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// Polylines in one set of arrays: line l is points offsets[l] … offsets[l+1). P points, L lines.
struct Isolines {
  Buffer<double> points;            ///< (P, 3) on the surface, in the unit of the positions
  Buffer<Index> edges;              ///< (P, 2) the mesh edge or polygon diagonal of every point, smaller vertex first
  Buffer<double> t;                 ///< (P,) in [0, 1], from the first vertex of the edge to the second
  std::vector<Index> offsets;       ///< (L + 1,)
  std::vector<std::uint8_t> closed; ///< (L,) 1: the last point joins the first (which is not repeated)
  std::vector<Index> level;         ///< (L,) index into the levels asked for; ascending
  std::vector<double> length;       ///< (L,) arc length, the closing segment included
};

/// Isolines of a piecewise-linear field: where it takes given values, as connected polylines.
///
/// A vertex is above a level c when field >= c, with no tolerance; so each triangle is crossed by 0 or 2 edges, every
/// line is closed or ends on a border (or at an edge with three or more faces), and a plateau at c lies above: the line
/// runs along its rim. Points that coincide in succession are one; a line shrunk to a point is dropped. Higher values
/// are on the left, seen from outside (on a surface without one outside: of the line's first triangle).
///
/// \param mesh    any polygons; they are crossed as mesh.triangulated(), repeated faces away from borders once.
/// \param field   (V,) NaN where undefined: triangles touching NaN carry no line; infinity is refused.
/// \param levels  (K,) finite, any order; of equal ones the first carries the lines.
/// \param cancel  stops the work within a fraction of a second, by a CancelledError
/// \throws InputError     wrong length, a level that is not finite, an infinite value (names the first offender),
///                        2^30 crossings of levels and triangles or more
/// \throws TopologyError  a polygon without a triangulation
/// Cost: O(V log K + F + output). Same result whatever the thread count. Thread-safe.
Isolines extract_isolines(const Mesh& mesh, std::span<const double> field, std::span<const double> levels,
                          const CancelToken& cancel = {});

} // namespace dirichlet
