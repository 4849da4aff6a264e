// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/laplacian.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "cotangent_laplacian.h"
#include "dirichlet/buffer.h"
#include "dirichlet/error.h"
#include "for_row.h"
#include "index.h"
#include "intrinsic_delaunay.h"
#include "message.h"
#include "parallel.h"
#include "polygon_laplacian.h"

namespace dirichlet {
namespace {

/// Whether no two vertices repel each other, beyond what rounding makes of a weight of 0.
bool has_maximum_principle(const SparseMatrix& K) {
  constexpr double kRounding = 1e-14;
  std::atomic<bool> attracting{true};
  parallel_chunks(at(static_cast<Index>(K.rows())), std::size_t{1} << 14, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end) && attracting; ++i) {
      double diagonal = 0, largest = 0;
      for_row(K, i, [&](Index j, double k) { (j == i ? diagonal : largest) = j == i ? k : std::max(largest, k); });
      if (largest > kRounding * diagonal) attracting = false;
    }
  });
  return attracting;
}

Stiffness graph(const Mesh& mesh) {
  Stiffness result{Laplacian::graph, {}, graph_stiffness(mesh), {}};
  const Eigen::VectorXd D = result.K.diagonal();
  result.mass.assign(D.begin(), D.end());
  return result;
}

/// All but K.
Stiffness begin(Laplacian laplacian, std::vector<double> mass, const FlatFaces& flat) {
  Stiffness result{laplacian, {}, {}, std::move(mass)};
  result.flat_faces = flat.count;
  result.first_flat = flat.count == 0 ? -1 : flat.first;
  return result;
}

Stiffness cotangent(const Mesh& mesh, const Cotangents& cotangents) {
  Stiffness result = begin(Laplacian::cotangent, cotangents.mass, cotangents.flat);
  result.K = cotangent_stiffness(mesh, cotangents.weights);
  result.maximum_principle = has_maximum_principle(result.K);
  return result;
}

Stiffness intrinsic_delaunay(const Mesh& mesh, const Cotangents& cotangents) {
  Stiffness result = begin(Laplacian::intrinsic_delaunay, cotangents.mass, cotangents.flat);
  result.K = intrinsic_delaunay_stiffness(mesh.triangulated());
  result.maximum_principle = has_maximum_principle(result.K);
  return result;
}

Stiffness polygon(PolygonLaplacian&& polygons) {
  Stiffness result = begin(Laplacian::polygon, std::move(polygons.mass), polygons.flat);
  result.K = std::move(polygons.K);
  result.maximum_principle = has_maximum_principle(result.K);
  return result;
}

Stiffness because(const char* reason, Stiffness result) {
  result.reason = reason;
  return result;
}

constexpr const char* kFlat = "no face has an area, and the graph Laplacian needs none";

Stiffness choose_for_triangles(const Mesh& mesh) {
  const Cotangents cotangents = measure_cotangents(mesh);
  if (cotangents.flat.count == mesh.face_count()) return because(kFlat, graph(mesh));
  Stiffness result = cotangent(mesh, cotangents);
  if (result.maximum_principle) return because("no cotangent weight of these triangles is negative", std::move(result));
  return because("some cotangent weights of these triangles are negative, and flipped edges mend that",
                 intrinsic_delaunay(mesh, cotangents));
}

Stiffness choose_for_polygons(const Mesh& mesh) {
  PolygonLaplacian polygons = polygon_laplacian(mesh);
  if (polygons.flat.count == mesh.face_count()) return because(kFlat, graph(mesh));
  Stiffness result = polygon(std::move(polygons));
  if (result.maximum_principle)
    return because("the faces are polygons none of whose weights is negative", std::move(result));
  return because("some weights of these polygons are negative, and those of triangles with flipped edges are not",
                 intrinsic_delaunay(mesh, measure_cotangents(mesh)));
}

void require_area(const Mesh& mesh, const FlatFaces& flat) {
  if (flat.count == mesh.face_count())
    throw InputError(
        message("none of the ", flat.count, " faces has an area, so only the graph Laplacian can be taken"));
}

} // namespace

Stiffness make_stiffness(const Mesh& mesh, Laplacian laplacian) {
  if (laplacian == Laplacian::graph) return graph(mesh);
  if (laplacian == Laplacian::automatic)
    return mesh.is_triangular() ? choose_for_triangles(mesh) : choose_for_polygons(mesh);
  if (laplacian == Laplacian::polygon) {
    PolygonLaplacian polygons = polygon_laplacian(mesh);
    require_area(mesh, polygons.flat);
    return polygon(std::move(polygons));
  }
  const Cotangents cotangents = measure_cotangents(mesh);
  require_area(mesh, cotangents.flat);
  return laplacian == Laplacian::cotangent ? cotangent(mesh, cotangents) : intrinsic_delaunay(mesh, cotangents);
}

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

SparseMatrix laplace_operator(Stiffness stiffness) {
  SparseMatrix& K = stiffness.K;
  for (Index i = 0; i < K.rows(); ++i) {
    double mass = stiffness.mass[at(i)];
    if (mass == 0) mass = K.coeff(i, i);
    if (mass == 0) continue;
    for (SparseMatrix::InnerIterator entry(K, i); entry; ++entry) {
      entry.valueRef() /= mass;
      if (!std::isfinite(entry.value()))
        throw InputError(message("vertex ", i, " has a mass of ", mass,
                                 ", whose inverse is too large a number: give the mesh a larger scale"));
    }
  }
  return std::move(K);
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
