// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/laplacian.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "cotangent_laplacian.h"
#include "dirichlet/buffer.h"
#include "dirichlet/error.h"
#include "for_row.h"
#include "index.h"
#include "intrinsic_delaunay.h"
#include "mesh_checks.h"
#include "message.h"
#include "parallel.h"
#include "polygon_laplacian.h"

namespace dirichlet {
namespace {

/// Whether no two vertices repel each other.
/// \param rounding  what it makes of a weight of 0, relative to the diagonal
bool has_maximum_principle(const SparseMatrix& K, double rounding) {
  std::atomic<bool> attracting{true};
  parallel_chunks(at(static_cast<Index>(K.rows())), std::size_t{1} << 14, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end) && attracting; ++i) {
      double diagonal = 0, largest = 0;
      for_row(K, i, [&](Index j, double k) { (j == i ? diagonal : largest) = j == i ? k : std::max(largest, k); });
      if (largest > rounding * diagonal) attracting = false;
    }
  });
  return attracting;
}

// Eigen 3.4 copies what is moved: a stiffness is filled in where it stays, and its matrix swapped in.

void take(SparseMatrix&& K, Stiffness& result, double rounding = 0) {
  result.K.swap(K);
  result.maximum_principle = has_maximum_principle(result.K, rounding);
}

void make_graph(const Mesh& mesh, Stiffness& result) {
  take(graph_stiffness(mesh), result);
  const Eigen::VectorXd D = result.K.diagonal();
  result.mass.assign(D.begin(), D.end());
}

void make_of_triangles(const Mesh& mesh, Laplacian laplacian, const Cotangents& cotangents, Stiffness& result) {
  result.laplacian = laplacian;
  result.mass = cotangents.mass;
  take(laplacian == Laplacian::cotangent
           ? cotangent_stiffness(mesh, cotangents.weights)
           : intrinsic_delaunay_stiffness(mesh.triangulated().without_repeats(), cotangents.weights, result.delaunay),
       result);
}

void make_polygon(PolygonLaplacian& polygons, Stiffness& result) {
  result.laplacian = Laplacian::polygon;
  result.mass.swap(polygons.mass);
  constexpr double kRounding = 1e-14; // of products of matrices
  take(std::move(polygons.K), result, kRounding);
}

void choose_graph(const Mesh& mesh, Stiffness& result) {
  make_graph(mesh, result);
  result.reason = "no face has an area, and the graph Laplacian needs none";
}

void choose_for_triangles(const Mesh& mesh, Stiffness& result) {
  const Cotangents cotangents = measure_cotangents(mesh);
  make_of_triangles(mesh, Laplacian::cotangent, cotangents, result);
  result.reason = "no cotangent weight of these triangles is negative";
  if (result.maximum_principle) return;
  make_of_triangles(mesh, Laplacian::intrinsic_delaunay, cotangents, result);
  result.reason = "some cotangent weights of these triangles are negative, and flipped edges mend that";
}

/// Whether blocks of k² entries would be most of the matrix, and its factor slow.
bool has_large_polygons(const Mesh& mesh) {
  constexpr std::int64_t kLarge = 64; // corners of a polygon, on the average over corners
  std::int64_t squares = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const std::int64_t k = mesh.offsets()[at(f) + 1] - mesh.offsets()[at(f)];
    squares += k * k;
  }
  return squares > kLarge * static_cast<std::int64_t>(mesh.corners().size());
}

/// What keeps the range of any painting: Delaunay triangles, or the graph where there are none.
void choose_triangles_of_polygons(const Mesh& mesh, const char* reason, Stiffness& result) {
  try {
    const Cotangents cotangents = measure_cotangents(mesh);
    make_of_triangles(mesh, Laplacian::intrinsic_delaunay, cotangents, result);
    result.reason = reason;
  } catch (const TopologyError&) {
    result = {};
    make_graph(mesh, result);
    result.reason = "a polygon crosses itself, so there are no triangles, and the graph Laplacian needs none";
  }
}

void choose_for_polygons(const Mesh& mesh, Stiffness& result) {
  if (has_large_polygons(mesh))
    return choose_triangles_of_polygons(mesh, "polygons of so many corners fill the matrix, and triangles do not",
                                        result);
  PolygonLaplacian polygons = polygon_laplacian(mesh);
  make_polygon(polygons, result);
  result.reason = "the faces are polygons none of whose weights is negative";
  if (!result.maximum_principle)
    choose_triangles_of_polygons(
        mesh, "some weights of these polygons are negative, and those of triangles with flipped edges are not", result);
}

bool has_area(const Mesh& mesh) {
  return at(mesh.face_count()) > mesh.flat_faces().size();
}

void require_area(const Mesh& mesh) {
  if (has_area(mesh)) return;
  const Index count = mesh.face_count();
  throw InputError(message(count == 1 ? std::string("face 0, the only one, has no area")
                                      : message("none of the ", count, " faces has an area"),
                           ", so only the graph Laplacian can be taken"));
}

void choose(const Mesh& mesh, Stiffness& result) {
  if (!has_area(mesh)) return choose_graph(mesh, result);
  mesh.is_triangular() ? choose_for_triangles(mesh, result) : choose_for_polygons(mesh, result);
}

} // namespace

Stiffness make_stiffness(const Mesh& whole, Laplacian laplacian) {
  Stiffness result;
  const Mesh& mesh = laplacian == Laplacian::graph ? whole : whole.without_repeats();
  if (laplacian != Laplacian::graph) check_positions(mesh.positions()); // they may have been moved since it was made
  if (laplacian == Laplacian::graph) {
    make_graph(mesh, result);
  } else if (laplacian == Laplacian::automatic) {
    choose(mesh, result);
  } else if (laplacian == Laplacian::polygon) {
    require_area(mesh);
    PolygonLaplacian polygons = polygon_laplacian(mesh);
    make_polygon(polygons, result);
  } else {
    require_area(mesh);
    const Cotangents cotangents = measure_cotangents(mesh);
    make_of_triangles(mesh, laplacian, cotangents, result);
  }
  return result;
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
  SparseMatrix L;
  L.swap(stiffness.K);
  for (Index i = 0; i < L.rows(); ++i) {
    double mass = stiffness.mass[at(i)];
    if (mass == 0) mass = L.coeff(i, i);
    if (mass == 0) continue;
    for (SparseMatrix::InnerIterator entry(L, i); entry; ++entry) {
      entry.valueRef() /= mass;
      if (!std::isfinite(entry.value()))
        throw InputError(message("vertex ", i, " has a mass of ", mass,
                                 ", whose inverse is too large a number: give the mesh a larger scale"));
    }
  }
  return L;
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
