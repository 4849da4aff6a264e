// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/laplacian.h"

#include <algorithm>

#include "dirichlet/buffer.h"
#include "index.h"

namespace dirichlet {

SparseMatrix graph_stiffness(const Mesh& mesh) {
  const Index n = mesh.vertex_count();
  const auto& edges = mesh.connectivity().edges;

  SparseMatrix K(n, n);
  Index* row = K.outerIndexPtr(); // (n + 1,)
  std::fill(row, row + n + 1, 0);
  for (const Index v : edges) ++row[v + 1];
  for (Index i = 0; i < n; ++i) row[i + 1] += row[i] + 1; // one more for the diagonal
  K.resizeNonZeros(row[n]);
  Index* column = K.innerIndexPtr();
  double* value = K.valuePtr();
  prefer_large_pages(column, at(row[n]) * sizeof(Index));
  prefer_large_pages(value, at(row[n]) * sizeof(double));

  std::fill(value, value + row[n], -1.0);
  // Edges come sorted by (smaller, larger) vertex. Going through them once fills every row in ascending columns: first
  // its smaller neighbours, whose edges come earlier, then the diagonal, then the larger ones.
  Buffer<Index> next(row, row + n);
  std::size_t e = 0;
  for (Index i = 0; i < n; ++i) {
    Index& mine = next[at(i)];
    value[mine] = row[i + 1] - row[i] - 1;
    column[mine++] = i;
    for (; e < edges.size() && edges[e] == i; e += 2) {
      const Index j = edges[e + 1];
      column[mine++] = j;
      column[next[at(j)]++] = i;
    }
  }
  return K;
}

SparseMatrix random_walk(SparseMatrix stiffness) {
  const Eigen::VectorXd D = stiffness.diagonal();
  for (Index i = 0; i < stiffness.rows(); ++i) {
    if (D[i] == 0) continue;
    for (SparseMatrix::InnerIterator entry(stiffness, i); entry; ++entry) entry.valueRef() /= D[i];
  }
  return stiffness;
}

} // namespace dirichlet
