// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_opposite.h"

#include <algorithm>
#include <utility>

#include "index.h"

namespace dirichlet {
namespace {

/// Corners [begin, end) of a polygon, or of the triangles it was split into.
struct Corners {
  Index begin, end;
};

using Ends = std::pair<Index, Index>;

Ends sorted(Index a, Index b) {
  return a < b ? Ends{a, b} : Ends{b, a};
}

Ends ends_in_triangle(std::span<const Index> triangles, Index corner) {
  return sorted(triangles[at(corner)], triangles[at(next_in_triangle(corner))]);
}

/// A polygon of k corners makes k - 2 triangles.
Corners triangles_of(const Mesh& mesh, Index face) {
  return {3 * (mesh.offsets()[at(face)] - 2 * face), 3 * (mesh.offsets()[at(face) + 1] - 2 * face - 2)};
}

/// Bisection over the polygons by `first(face)`, ascending: the last one that begins at or before `corner`.
template <class First>
Index last_face(const Mesh& mesh, Index corner, First first) {
  Index face = 0;
  for (Index end = mesh.face_count(); end - face > 1;) {
    const Index middle = face + (end - face) / 2;
    (first(middle) <= corner ? face : end) = middle;
  }
  return face;
}

/// A half-edge of the face's triangles that has these ends, other than `except`.
Index find_in_triangles(const Mesh& mesh, Index face, Ends ends, Index except) {
  const Corners range = triangles_of(mesh, face);
  for (Index c = range.begin; c < range.end; ++c)
    if (c != except && ends_in_triangle(mesh.triangulated().corners(), c) == ends) return c;
  return Connectivity::kNonManifold;
}

/// The corner of the polygon whose side has these ends, or -1.
Index find_side(const Mesh& mesh, Index face, Ends ends) {
  const Corners range{mesh.offsets()[at(face)], mesh.offsets()[at(face) + 1]};
  for (Index c = range.begin; c < range.end; ++c)
    if (sorted(mesh.corners()[at(c)], mesh.corners()[at(c + 1 < range.end ? c + 1 : range.begin)]) == ends) return c;
  return -1;
}

} // namespace

Index opposite_in_polygons(const Mesh& mesh, Index half_edge) {
  const Ends ends = ends_in_triangle(mesh.triangulated().corners(), half_edge);
  const Index face = last_face(mesh, half_edge, [&](Index f) { return triangles_of(mesh, f).begin; });
  const Index side = find_side(mesh, face, ends);
  if (side < 0) return find_in_triangles(mesh, face, ends, half_edge); // a diagonal: both its triangles are here
  const Index other = mesh.connectivity().opposite[at(side)];
  if (other < 0) return other;
  const Index neighbour = last_face(mesh, other, [&](Index f) { return mesh.offsets()[at(f)]; });
  return find_in_triangles(mesh, neighbour, ends, half_edge);
}

} // namespace dirichlet
