// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dirichlet/buffer.h"
#include "dirichlet/cancel.h"
#include "dirichlet/mesh.h"
#include "level_numbers.h"

namespace dirichlet {

/// The combinatorial half of isolines, without a coordinate. Levels are ranks 0 … K - 1 in ascending order; numbers[v]
/// is how many of them are <= the value of vertex v, so that v is above level k when numbers[v] > k; kUndefined where v
/// has no value.
///
/// Lines by the half-edges of the triangles that they cross: line l has half_edges[offsets[l]] … [offsets[l + 1]), in
/// order, with higher values on the left of its first triangle, the lowest one. An open line starts and ends where
/// there is no way on. Lines of one level are sorted by their first triangles.
struct Traces {
  Buffer<Index> half_edges;
  std::vector<Index> offsets{0};    ///< (L + 1,)
  std::vector<std::uint8_t> closed; ///< (L,)
  std::vector<Index> level;         ///< (L,)
};

/// The lines of all levels over mesh.triangulated(). All triangles are looked at once, in order, and where a line goes
/// on is found there and then: following lines through a large mesh would wait for memory at every step.
/// \throws InputError  2^30 crossings of triangles and levels or more. Cost: O(T + crossings).
Traces trace_lines(const Mesh& mesh, std::span<const Index> numbers, const CancelToken& cancel);

} // namespace dirichlet
