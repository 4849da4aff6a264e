// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// n × n in compressed rows (CSR), column indices ascending in every row.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

/// The same where it is only read, wherever its arrays are; columns in any order. Compressed.
using SparseView = Eigen::Ref<const SparseMatrix>;

/// The stiffness matrix of the graph Laplacian, K = D − A: symmetric, positive semi-definite, rows sum to 0.
///
/// A(i,j) = 1 where the mesh has the *polygon* edge (i,j), diagonals do not count; D(i,i) is the number of one-ring
/// neighbours. K(i,i) is stored for every vertex, 0 at an isolated one. Duplicate faces count once.
/// Cost: O(V + E); assembled in place, memory of the result alone. Source: "Dirichlet Surface Isolines", eq. (1).
SparseMatrix graph_stiffness(const Mesh& mesh);

/// The operator itself, L = D⁻¹K = I − D⁻¹A: every row with its own diagonal scaled to 1. The row of an isolated vertex
/// stays 0: it has no equation. Works for any symmetric stiffness, whose mass is then its diagonal.
SparseMatrix random_walk(SparseMatrix stiffness);

} // namespace dirichlet
