// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "dirichlet/array.h"
#include "dirichlet/buffer.h"
#include "dirichlet/lazy.h"

namespace dirichlet {

/// Who touches whom, as index arrays. A *corner* is a vertex in a face, and stands for the half-edge that leaves it
/// towards the next corner of that face.
struct Connectivity {
  static constexpr Index kBorder = -1;      ///< opposite: the edge has no other face
  static constexpr Index kNonManifold = -2; ///< opposite: the edge has three or more half-edges

  Buffer<Index> edges;    ///< (E, 2) vertices, smaller first; edges sorted by (first, second)
  Buffer<Index> opposite; ///< (C,) the edge's other half-edge, of either direction; or kBorder, kNonManifold
};

/// Connected pieces: (V,) piece of every vertex, pieces numbered by their lowest vertex. An isolated vertex is a piece.
struct Components {
  std::vector<Index> label; ///< (V,)
  Index count = 0;
};

/// Loops of border edges. Loop k is vertices[offsets[k] … offsets[k+1]), in order, the surface on the left.
struct BorderLoops {
  std::vector<Index> offsets;  ///< (B + 1,)
  std::vector<Index> vertices; ///< every loop starts at its lowest vertex
};

struct Groups;

/// A polygon mesh: positions, faces and their connectivity. Immutable, and safe to read from several threads.
///
/// Any number of corners per face, any number of faces per edge, any orientation, vertices without a face: all legal.
/// A corner repeated in direct succession (the quad a b c c) counts once; a face that repeats a vertex otherwise, or
/// has fewer than three left, is refused.
class Mesh {
 public:
  /// \param positions  (V, 3) finite, any unit, C order; used in place.
  /// \param offsets    (F + 1,) where every face starts in `corners`: 0, …, C, ascending; copied.
  /// \param corners    (C,) vertex of every corner, in [0, V); copied, since a later write could break the mesh.
  /// \throws InputError     wrong lengths, no faces, a number that is not finite, an index out of range
  /// \throws TopologyError  a face with fewer than three vertices or one twice
  /// Cost: O(V + C) by counting sorts, but for vertices of many edges, whose k edges take O(k log k); all cores on
  /// large meshes.
  Mesh(SharedArray<double> positions, std::span<const Index> offsets, std::span<const Index> corners);

  /// Faces of one size: (F, corners_per_face). Else as above.
  Mesh(SharedArray<double> positions, std::span<const Index> corners, Index corners_per_face);

  /// The faces of another mesh with their vertices elsewhere, for surfaces that move.
  /// \param positions  (V, 3) as above, of as many vertices.
  /// \throws InputError  another number of vertices, a number that is not finite
  /// Cost: O(V + C), copies alone.
  Mesh(const Mesh& faces, SharedArray<double> positions);

  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;

  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(positions_.size() / 3); }
  [[nodiscard]] Index face_count() const { return static_cast<Index>(offsets_.size()) - 1; }
  [[nodiscard]] Index edge_count() const { return static_cast<Index>(connectivity_.edges.size() / 2); }
  [[nodiscard]] std::span<const double> positions() const { return positions_.view(); } ///< (V, 3)
  [[nodiscard]] const SharedArray<double>& shared_positions() const { return positions_; }
  [[nodiscard]] std::span<const Index> offsets() const { return offsets_; } ///< (F + 1,)
  [[nodiscard]] std::span<const Index> corners() const { return corners_; } ///< (C,)
  [[nodiscard]] const Connectivity& connectivity() const { return connectivity_; }

  /// Whether every face has three corners: then corner c belongs to face c / 3.
  [[nodiscard]] bool is_triangular() const { return triangular_; }

  /// The same surface in triangles, over the same vertices: this mesh itself when it is triangular, else a mesh made at
  /// the first call and kept (see triangulation.h). \throws TopologyError  a polygon that has no triangulation.
  [[nodiscard]] const Mesh& triangulated() const;

  /// Faces that repeat an earlier one, in either direction and from any corner, and that one: ascending. Found at the
  /// first call and kept; two faces that are each other's back, and meet no others, are a pillow and none repeated.
  [[nodiscard]] std::span<const std::array<Index, 2>> repeated_faces() const;

  /// The same surface with every face once: this mesh itself unless faces are repeated, else a mesh over the same
  /// vertices and edges, made at the first call and kept.
  [[nodiscard]] const Mesh& without_repeats() const;

  /// The same but for repeats at a border, which stay: lines that reach one go over the border and back on it, as they
  /// do on any two faces, and at the sides of the others every line would end.
  [[nodiscard]] const Mesh& without_inner_repeats() const;

  /// The number of a face in the mesh that repeats were left out of, by which its maker knows it; else its own.
  [[nodiscard]] Index number_with_repeats(Index face) const;

  /// Of faces, ascending, those that repeat no other.
  [[nodiscard]] std::vector<Index> each_once(std::span<const Index> faces) const;

  /// Faces without an area, ascending; of repeated ones the first. All their corners lie on one line, as far as rounded
  /// coordinates can tell. Found at the first call and kept.
  [[nodiscard]] std::span<const Index> flat_faces() const;

  /// The corners at every vertex, ascending: what a walk over the surface needs, and nothing else. Made at the first
  /// call and kept.
  [[nodiscard]] const Groups& corners_by_vertex() const;

  [[nodiscard]] Components components() const;                          ///< Cost: O(V + E)
  [[nodiscard]] BorderLoops border_loops() const;                       ///< Cost: O(V + E)
  [[nodiscard]] double build_seconds() const { return build_seconds_; } ///< wall time of validation and connectivity

 private:
  Mesh(const Mesh& whole, std::vector<Index> left_out);
  void build(Buffer<Index> offsets, std::span<const Index> corners);
  [[nodiscard]] std::unique_ptr<const Mesh> leave_out(std::vector<Index> faces) const;

  SharedArray<double> positions_;
  Buffer<Index> offsets_;
  Buffer<Index> corners_;
  Connectivity connectivity_;
  bool triangular_ = false;
  double build_seconds_ = 0;
  std::vector<Index> left_out_; ///< repeats of the mesh that this one was made of, ascending
  Lazy<std::unique_ptr<const Mesh>> triangulated_;
  Lazy<std::vector<std::array<Index, 2>>> repeated_faces_;
  Lazy<std::unique_ptr<const Mesh>> without_repeats_;
  Lazy<std::unique_ptr<const Mesh>> without_inner_repeats_;
  Lazy<std::vector<Index>> flat_faces_;
  Lazy<std::shared_ptr<const Groups>> corners_by_vertex_;
};

} // namespace dirichlet
