// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "dirichlet/buffer.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// Triangles glued along their sides and known by their lengths alone: it may have two edges between the same vertices,
/// and edges from a vertex to itself. Half-edges 3 f, 3 f + 1, 3 f + 2 go around triangle f.
class IntrinsicTriangulation {
 public:
  static constexpr Index kBorder = -1; ///< twin: the side is glued to nothing

  struct HalfEdge {
    Index twin;            ///< the half-edge it is glued to, which runs the other way; or kBorder
    Index tail;            ///< the vertex where it begins
    double length;         ///< > 0, the twin's as well
    double half_cotangent; ///< ½ cot of the opposite angle
  };

  /// 72 bytes per triangle.
  explicit IntrinsicTriangulation(Buffer<HalfEdge> half_edges) : half_edges_(std::move(half_edges)) {}

  [[nodiscard]] const Buffer<HalfEdge>& half_edges() const { return half_edges_; }

  /// Flips edges until none has opposite angles of more than π together, beyond what rounding can tell. Sides glued to
  /// nothing stay.
  ///
  /// Ends on its own, but for rounding and for triangles so much longer than wide that it would take too long: it gives
  /// up after 64 flips per triangle and a million more. \returns the flips
  /// Cost: O(T + flips). Source: Fisher, Springborn, Bobenko, Schröder, "An Algorithm for the Construction of Intrinsic
  /// Delaunay Triangulations with Applications to Digital Geometry Processing", 2006.
  std::int64_t make_delaunay();

 private:
  [[nodiscard]] HalfEdge& half_edge(Index h) { return half_edges_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] bool is_delaunay(Index h);
  [[nodiscard]] Buffer<Index> find_others();
  [[nodiscard]] double other_diagonal(Index h);
  bool flip(Index h);

  Buffer<HalfEdge> half_edges_;
};

} // namespace dirichlet
