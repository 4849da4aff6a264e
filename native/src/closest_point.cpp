// SPDX-License-Identifier: GPL-3.0-or-later
#include "closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "index.h"
#include "parallel.h"
#include "vector3.h"

namespace dirichlet {
namespace {

/// The best point so far of those offered, as seen from the origin.
struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  std::array<double, 3> weights{};

  void offer(const std::array<Vector3, 3>& corner, const std::array<double, 3>& w) {
    const Vector3 p = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2];
    if (const double d = dot(p, p); d < squared) *this = {d, w};
  }
};

/// Judges candidates by the distance they really have, so that rounding can cost a little nearness in a needle, but
/// never leave the triangle.
Nearest nearest_to_origin(const std::array<Vector3, 3>& corner) {
  Nearest best;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vector3 edge = corner[j] - corner[i];
    const double length = dot(edge, edge);
    const double t = length > 0 ? std::clamp(-dot(corner[i], edge) / length, 0.0, 1.0) : 0.0;
    std::array<double, 3> w{};
    w[i] = 1 - t;
    w[j] = t;
    best.offer(corner, w);
  }
  const Vector3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double area = dot(normal, normal); // if it is 0, no comparison below holds
  const double v = dot(cross(corner[2], corner[0]), normal) / area;
  const double w = dot(cross(corner[0], corner[1]), normal) / area;
  if (v > 0 && w > 0 && v + w < 1) best.offer(corner, {1 - v - w, v, w});
  return best;
}

/// Among the triangles of these corners. \param size  no less than half the largest difference in a coordinate
SurfacePoint closest_point(std::span<const Index> corners, std::span<const double> positions,
                           const std::array<double, 3>& point, double size) {
  const double scale = unit_scale(size);
  const auto seen_from_point = [&](Index vertex) {
    const auto v = 3 * at(vertex);
    const auto axis = [&](std::size_t i) { return (positions[v + i] / 2 - point[i] / 2) * scale; };
    return Vector3{axis(0), axis(1), axis(2)};
  };

  std::mutex mutex;
  Nearest best;
  std::size_t place = 0;
  parallel_chunks(corners.size() / 3, std::size_t{1} << 14, [&](std::size_t begin, std::size_t end) {
    Nearest mine;
    std::size_t where = begin;
    for (std::size_t f = begin; f < end; ++f) {
      const auto corner = [&](std::size_t i) { return seen_from_point(corners[3 * f + i]); };
      const Nearest here = nearest_to_origin({corner(0), corner(1), corner(2)});
      if (!(here.squared < mine.squared)) continue;
      mine = here;
      where = f;
    }
    const std::scoped_lock lock(mutex);
    if (mine.squared > best.squared || (mine.squared == best.squared && where > place)) return;
    best = mine;
    place = where;
  });
  return {{corners[3 * place], corners[3 * place + 1], corners[3 * place + 2]}, best.weights};
}

} // namespace

SurfacePoint closest_point(const Mesh& triangles, const std::array<double, 3>& point) {
  const auto positions = triangles.positions();
  double size = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    size = std::max(size, std::abs(positions[i] / 2 - point[i % 3] / 2));
  return closest_point(triangles.corners(), positions, point, size);
}

SurfacePoint closest_point(const Mesh& triangles, const std::array<double, 3>& point, Index first, Index last) {
  const auto corners = triangles.corners().subspan(3 * at(first), 3 * at(last - first));
  const auto positions = triangles.positions();
  double size = 0;
  for (const Index v : corners)
    for (std::size_t axis = 0; axis < 3; ++axis)
      size = std::max(size, std::abs(positions[3 * at(v) + axis] / 2 - point[axis] / 2));
  return closest_point(corners, positions, point, size);
}

} // namespace dirichlet
