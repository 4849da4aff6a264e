// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "dirichlet/cancel.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// Vertices near a point, and how near they are.
struct GeodesicDisc {
  std::vector<Index> vertices;   ///< (C,) ascending
  std::vector<double> distances; ///< (C,) aligned with them, in the unit of the positions
};

/// The vertices whose distance from a point, measured along the surface, is at most `radius`: a brush that does not
/// jump from one sheet to another beside it.
///
/// A front from the point takes in the nearest vertex again and again. A vertex behind an edge is as far as from the
/// point of its triangle's plane that has the distances of the edge's ends, if the straight way from there meets the
/// edge; else it is reached along an edge. So distances are those of straight lines, to rounding, where the surface is
/// flat around the point and its triangles are Delaunay, and along straight chains of edges everywhere; on curved
/// surfaces they approach the geodesic distance at first order in the size of the triangles. They are never below the
/// straight distance in space, and a larger radius holds every vertex that a smaller one does.
/// Source: Melvær and Reimers, "Geodesic polar coordinates on polygonal meshes", 2012, after Kimmel and Sethian 1998.
///
/// \param mesh    any polygons, as mesh.triangulated(); edges of any number of faces, triangles without an area.
/// \param point   the disc's middle is the surface's nearest point to it.
/// \param radius  >= 0, infinite for all that hangs together with the point. A radius smaller than the way to the
///                nearest vertex gives an empty disc, one of 0 the vertex that the point is, if it is one.
/// \param face    the polygon of the mesh that the middle lies on, which spares the search for it.
/// \param cancel  stops the front within a fraction of a second, by a CancelledError
/// \throws InputError     a coordinate that is not finite, a radius below 0 or NaN, no such face
/// \throws TopologyError  a polygon that has no triangulation
/// Cost: O(k log k) for a disc and its rim of k vertices; the first call for a mesh O(V + F); without `face` O(F).
/// Same result whatever the thread count. Thread-safe.
GeodesicDisc geodesic_disc(const Mesh& mesh, const std::array<double, 3>& point, double radius,
                           std::optional<Index> face = std::nullopt, const CancelToken& cancel = {});

} // namespace dirichlet
