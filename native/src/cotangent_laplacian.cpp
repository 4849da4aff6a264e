// SPDX-License-Identifier: GPL-3.0-or-later
#include "cotangent_laplacian.h"

#include <array>
#include <cmath>
#include <limits>

#include "edge_weights.h"
#include "index.h"
#include "parallel.h"
#include "triangle_shape.h"

namespace dirichlet {

Cotangents measure_cotangents(const Mesh& mesh) {
  const Mesh& triangles = mesh.triangulated().without_repeats();
  const auto corners = triangles.corners();
  Cotangents result;
  result.weights.resize(corners.size());
  Buffer<double> area(at(triangles.face_count()));

  const auto measure = [&](Index t) {
    std::array<Vector3, 3> points;
    for (std::size_t k = 0; k < 3; ++k) points[k] = point(mesh.positions(), corners[3 * at(t) + k]);
    const TriangleShape shape = triangle_shape(points);
    for (std::size_t k = 0; k < 3; ++k) result.weights[3 * at(t) + (k + 1) % 3] = shape.cotangents[k] / 2;
    area[at(t)] = shape.area;
  };
  constexpr std::size_t kGrain = 1 << 12;
  parallel_chunks(area.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t) measure(t);
  });

  result.mass.assign(at(mesh.vertex_count()), 0.0);
  for (std::size_t c = 0; c < corners.size(); ++c) result.mass[at(corners[c])] += area[c / 3] / 3;
  return result;
}

namespace {

/// One angle's weight and the opposite one's, 0 where rounding cannot tell it from that: of two right angles.
double weight(double one, double other) {
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  const double sum = one + other;
  return sum < 0 && sum >= -kRounding * (1 + std::abs(one) + std::abs(other)) ? 0 : sum;
}

} // namespace

SparseMatrix cotangent_stiffness(const Mesh& mesh, std::span<const double> weights) {
  const auto corners = mesh.triangulated().without_repeats().corners();
  const auto& opposite = mesh.triangulated().without_repeats().connectivity().opposite;
  Buffer<Index> edges;
  Buffer<double> sums;
  edges.reserve(corners.size() + corners.size() / 8); // a closed surface has half as many edges as half-edges
  sums.reserve(corners.size() / 2 + corners.size() / 16);
  for (Index c = 0; c < static_cast<Index>(corners.size()); ++c) {
    const Index other = opposite[at(c)]; // or none, or, on an edge of three and more faces, each for itself
    if (other >= 0 && other < c) continue;
    edges.push_back(corners[at(c)]);
    edges.push_back(corners[at(next_in_triangle(c))]);
    sums.push_back(weight(weights[at(c)], other >= 0 ? weights[at(other)] : 0));
  }
  return stiffness_of_edges(mesh.vertex_count(), edges, sums);
}

} // namespace dirichlet
