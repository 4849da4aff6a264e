// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_opposite.h"

#include <algorithm>
#include <utility>

#include "groups.h"
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

/// The one corner in `range`, other than `except`, whose side has these ends; or -1. It starts at one of them, where
/// few corners are, or the one before it does.
/// \param ends_of   of the side that starts at a corner
/// \param previous  the corner before another in the same face
template <class EndsOf, class Previous>
Index find_side(const Mesh& mesh, Corners range, Ends ends, Index except, const EndsOf& ends_of,
                const Previous& previous) {
  const Groups& around = mesh.corners_by_vertex();
  const bool first_is_rarer = around[ends.first].size() <= around[ends.second].size();
  const auto corners = around[first_is_rarer ? ends.first : ends.second]; // ascending
  for (auto c = std::lower_bound(corners.begin(), corners.end(), range.begin); c != corners.end() && *c < range.end;
       ++c)
    for (const Index side : {*c, previous(*c)})
      if (side != except && ends_of(side) == ends) return side;
  return -1;
}

/// A half-edge of the face's triangles that has these ends, other than `except`.
Index find_in_triangles(const Mesh& mesh, Index face, Ends ends, Index except) {
  const Mesh& triangles = mesh.triangulated();
  const Index found = find_side(
      triangles, triangles_of(mesh, face), ends, except,
      [&](Index c) { return ends_in_triangle(triangles.corners(), c); },
      [](Index c) { return next_in_triangle(next_in_triangle(c)); });
  return found < 0 ? Connectivity::kNonManifold : found;
}

/// The corner of the polygon whose side has these ends, or -1.
Index find_in_polygon(const Mesh& mesh, Index face, Ends ends) {
  const Corners range{mesh.offsets()[at(face)], mesh.offsets()[at(face) + 1]};
  return find_side(
      mesh, range, ends, -1,
      [&](Index c) {
        return sorted(mesh.corners()[at(c)], mesh.corners()[at(c + 1 < range.end ? c + 1 : range.begin)]);
      },
      [&](Index c) { return (c > range.begin ? c : range.end) - 1; });
}

} // namespace

Index opposite_in_polygons(const Mesh& mesh, Index half_edge) {
  const Ends ends = ends_in_triangle(mesh.triangulated().corners(), half_edge);
  const Index face = last_face(mesh, half_edge, [&](Index f) { return triangles_of(mesh, f).begin; });
  const Index side = find_in_polygon(mesh, face, ends);
  if (side < 0) return find_in_triangles(mesh, face, ends, half_edge); // a diagonal: both its triangles are here
  const Index other = mesh.connectivity().opposite[at(side)];
  if (other < 0) return other;
  const Index neighbour = last_face(mesh, other, [&](Index f) { return mesh.offsets()[at(f)]; });
  return find_in_triangles(mesh, neighbour, ends, half_edge);
}

} // namespace dirichlet
