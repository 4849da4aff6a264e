// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_shape.h"

#include <algorithm>
#include <cmath>

namespace dirichlet {

TriangleShape triangle_shape(const std::array<Vector3, 3>& corners) {
  std::array<Vector3, 3> edges; // opposite to every corner
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    size = std::max(size, largest_part(edges[k]));
  }
  if (size == 0) return {{1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}, 0};
  const double scale = unit_scale(size);
  for (Vector3& edge : edges) edge = scale * edge;

  std::array<double, 3> squares{};
  for (std::size_t k = 0; k < 3; ++k) squares[k] = dot(edges[k], edges[k]);
  const auto apex = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const std::size_t left = (apex + 1) % 3, right = (apex + 2) % 3;
  const Vector3 normal = cross(edges[left], edges[right]);
  const double square = squares[apex], twice_area = std::sqrt(dot(normal, normal));

  TriangleShape shape;
  shape.area = twice_area / 2 / scale / scale;
  // Where the height meets the longest edge, as shares of it.
  const double from_left = -dot(edges[right], edges[apex]) / square,
               from_right = -dot(edges[left], edges[apex]) / square;
  const double least = std::max(kLeastHeight, 4 * kLeastCap * from_left * from_right);
  if (const double height = twice_area / square; height < least) {
    shape.cotangents[left] = from_left / least;
    shape.cotangents[right] = from_right / least;
    shape.cotangents[apex] = (least * least - from_left * from_right) / least;
  } else {
    shape.cotangents[left] = from_left / height;
    shape.cotangents[right] = from_right / height;
    shape.cotangents[apex] = -dot(edges[left], edges[right]) / twice_area;
  }
  return shape;
}

} // namespace dirichlet
