// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// n × n in compressed rows (CSR), column indices ascending in every row.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

/// The same where it is only read, wherever its arrays are; columns in any order. Compressed.
using SparseView = Eigen::Ref<const SparseMatrix>;

/// The operators L = mass⁻¹ K, from the one that sees no positions to those that see all of the shape.
enum class Laplacian : std::uint8_t {
  automatic,          ///< the one a careful expert would take; see make_stiffness
  graph,              ///< the paper's: every neighbour counts alike. Any mesh, however bad
  cotangent,          ///< linear finite elements on the triangles; exact where nothing is obtuse
  intrinsic_delaunay, ///< the same on the surface's Delaunay triangulation: keeps the painted range on any mesh
  polygon,            ///< finite elements on quads and n-gons, of which no diagonal is preferred
};

/// Where intrinsic_delaunay is less than its name says. The maximum principle holds all the same.
struct DelaunayNotes {
  Index thickened = 0; ///< triangles taken as thicker than they are, and not flat
  Index unflipped = 0; ///< edges whose negative weight counts as none, since flips would have taken too long
  /// Edges of a border opposite to more than 135 degrees, ascending. A border's negative weights count as none, and
  /// theirs would be beyond -1/2, as much as an edge between two good triangles has.
  std::vector<std::array<Index, 2>> obtuse;

  [[nodiscard]] std::vector<std::string> warnings() const; ///< of thickened and unflipped, one sentence each
};

/// The two matrices of an operator, and what is to be known about them.
struct Stiffness {
  Laplacian laplacian = Laplacian::graph; ///< never automatic
  std::string reason;                     ///< one sentence: why automatic took it; else empty
  SparseMatrix K;           ///< (V, V) symmetric, positive semi-definite, rows sum to 0; every diagonal is stored
  std::vector<double> mass; ///< (V,) >= 0, the lumped one; 0 at an isolated vertex
  /// Whether no weight is negative, beyond rounding: harmonic fields then stay in the painted range.
  bool maximum_principle = true;
  DelaunayNotes delaunay;
};

/// Any operator of a mesh, in which repeated faces count once; so do triangles that polygons share once they are split,
/// as a quad and its half do, in the two operators of triangles.
///
/// graph: K = D − A and mass D, from polygon edges alone; see graph_stiffness.
/// cotangent: of Mesh::triangulated(). A weight is half the cotangents opposite to the edge, a mass a third of the
/// areas
///   around: they sum to the area.
/// intrinsic_delaunay: of Mesh::triangulated(), its edges flipped along the surface until no weight is negative; masses
///   as above.
/// polygon: every polygon of k > 3 corners becomes k triangles around a virtual vertex, which is then expressed by the
///   corners: a block of k² entries. Source: Bunge, Herholz, Kazhdan, Botsch: "Polygon Laplacian Made Simple" (2020).
///   Reproduces linear functions of the plane where the virtual vertex sees every side, in convex polygons always.
/// automatic: the cotangent or, for polygons of few corners, the polygon Laplacian where it has a maximum principle;
///   else intrinsic_delaunay; the graph where no face has an area or one has no triangulation.
///
/// Coordinates may have any scale and offset. A triangle without height, or of a height below 6e-14 of its longest
/// edge (1.5e-8 where its foot is in the middle), counts as one of that height. Intrinsic_delaunay takes triangles with
/// an angle within 5e-7 of π as thicker, and counts them; of wider ones, two on one long edge with heights of h of it
/// are flipped to about 1e-16 / h².
///
/// \throws InputError     no face has an area, and the operator asked for needs one; polygons whose blocks are too many
/// \throws TopologyError  a polygon that has no triangulation, if one is needed
/// Cost: O(V + C); the polygon Laplacian O(V + sum of k²).
Stiffness make_stiffness(const Mesh& mesh, Laplacian laplacian);

/// The stiffness matrix of the graph Laplacian, K = D − A: symmetric, positive semi-definite, rows sum to 0.
///
/// A(i,j) = 1 where the mesh has the *polygon* edge (i,j), diagonals do not count; D(i,i) is the number of one-ring
/// neighbours. K(i,i) is stored for every vertex, 0 at an isolated one. Duplicate faces count once.
/// Cost: O(V + E); assembled in place, memory of the result alone. Source: "Dirichlet Surface Isolines", eq. (1).
SparseMatrix graph_stiffness(const Mesh& mesh);

/// The operator itself, L = mass⁻¹ K; of the graph, I − D⁻¹A. A row without mass is scaled to a diagonal of 1: the same
/// equation as long as it has no source. That of an isolated vertex stays 0: it has no equation.
/// \throws InputError  a mass so small that its inverse is not finite
SparseMatrix laplace_operator(Stiffness stiffness);

/// D⁻¹K: every row with its own diagonal scaled to 1. That of an isolated vertex stays 0.
SparseMatrix random_walk(SparseMatrix stiffness);

} // namespace dirichlet
