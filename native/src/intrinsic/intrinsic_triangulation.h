// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "dirichlet/buffer.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// The most flips of one triangulation if not 0, else as make_delaunay says. For tests.
inline std::atomic<std::int64_t> flip_limit{0};

/// Triangles glued along their sides and known by their angles alone: it may have two edges between the same vertices,
/// and edges from a vertex to itself. Half-edges 3 f, 3 f + 1, 3 f + 2 go around triangle f.
class IntrinsicTriangulation {
 public:
  static constexpr Index kBorder = -1; ///< twin: the side is glued to nothing

  struct HalfEdge {
    Index twin;            ///< the half-edge it is glued to, which runs the other way; or kBorder
    Index tail;            ///< the vertex where it begins
    double half_cotangent; ///< ½ cot of the opposite angle
  };

  /// 48 bytes per triangle.
  explicit IntrinsicTriangulation(Buffer<HalfEdge> half_edges) : half_edges_(std::move(half_edges)) {}

  [[nodiscard]] const Buffer<HalfEdge>& half_edges() const { return half_edges_; }

  /// Flips edges until none has opposite angles of more than π together, beyond what rounding can tell. Sides glued to
  /// nothing stay.
  ///
  /// Ends on its own, but for rounding and for triangles so much longer than wide that it would take too long: it gives
  /// up after 64 flips per triangle and a million more, or flip_limit. \returns the edges that then still want
  /// flipping; 0 where it did not give up.
  ///
  /// Cost: O(T + flips). Source: Fisher, Springborn, Bobenko, Schröder, "An
  /// Algorithm for the Construction of Intrinsic Delaunay Triangulations with Applications to Digital Geometry
  /// Processing", 2006.
  Index make_delaunay();

 private:
  [[nodiscard]] HalfEdge& half_edge(Index h) { return half_edges_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] bool is_delaunay(Index h);
  [[nodiscard]] Buffer<Index> find_others();
  bool flip(Index h);

  Buffer<HalfEdge> half_edges_;
};

} // namespace dirichlet
