// SPDX-License-Identifier: GPL-3.0-or-later
#include "cotangent_laplacian.h"

#include <algorithm>
#include <array>

#include "edge_weights.h"
#include "index.h"
#include "triangle_shape.h"

namespace dirichlet {

Cotangents measure_cotangents(const Mesh& mesh) {
  const Mesh& triangles = mesh.triangulated();
  const auto corners = triangles.corners(), offsets = mesh.offsets();
  Cotangents result;
  result.weights.resize(corners.size());
  Buffer<double> area(at(triangles.face_count()));

  const auto measure = [&](Index t) {
    std::array<Vector3, 3> points;
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = point(mesh.positions(), corners[3 * at(t) + k]);
      largest = std::max(largest, largest_part(points[k]));
    }
    const TriangleShape shape = triangle_shape(points, rounding_of(largest));
    for (std::size_t k = 0; k < 3; ++k) result.weights[3 * at(t) + (k + 1) % 3] = shape.cotangents[k] / 2;
    area[at(t)] = shape.area;
    return shape.flat;
  };
  result.flat = find_flat_faces(mesh.face_count(), [&] {
    return [&](Index face) {
      bool flat = true; // a polygon of k corners is k - 2 triangles
      for (Index t = offsets[at(face)] - 2 * face; t < offsets[at(face) + 1] - 2 * face - 2; ++t)
        flat = measure(t) && flat;
      return flat;
    };
  });

  result.mass.assign(at(mesh.vertex_count()), 0.0);
  for (std::size_t c = 0; c < corners.size(); ++c) result.mass[at(corners[c])] += area[c / 3] / 3;
  return result;
}

SparseMatrix cotangent_stiffness(const Mesh& mesh, std::span<const double> weights) {
  const auto corners = mesh.triangulated().corners();
  const auto& opposite = mesh.triangulated().connectivity().opposite;
  Buffer<Index> edges;
  Buffer<double> sums;
  edges.reserve(corners.size() + corners.size() / 8); // a closed surface has half as many edges as half-edges
  sums.reserve(corners.size() / 2 + corners.size() / 16);
  for (Index c = 0; c < static_cast<Index>(corners.size()); ++c) {
    const Index other = opposite[at(c)]; // or none, or, on an edge of three and more faces, each for itself
    if (other >= 0 && other < c) continue;
    edges.push_back(corners[at(c)]);
    edges.push_back(corners[at(next_in_triangle(c))]);
    sums.push_back(weights[at(c)] + (other >= 0 ? weights[at(other)] : 0));
  }
  return stiffness_of_edges(mesh.vertex_count(), edges, sums);
}

} // namespace dirichlet
