// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "dirichlet/isolines.h"
#include "index.h"

namespace dirichlet {

using Point = std::array<double, 3>;

/// Squares of the usual lengths are the quick way; those that would vanish take the long one.
inline double distance(const Point& a, const Point& b) {
  const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  const double squared = x * x + y * y + z * z;
  return squared > 1e-280 ? std::sqrt(squared) : std::hypot(x, y, z);
}

/// std::lerp for t in [0, 1], which a compiler makes fast: exact at both ends, and never outside them.
inline double between(double a, double b, double t) {
  const double sum = t * b + (1 - t) * a, x = a + t * (b - a);
  const double low = b > x ? x : b, high = b < x ? x : b;
  const double clamped = b > a ? low : high;
  const double inner = t == 1 ? b : clamped;
  const bool around_zero = ((a <= 0) & (b >= 0)) | ((a >= 0) & (b <= 0));
  return around_zero ? sum : inner;
}

inline Point point(const Isolines& lines, std::size_t i) {
  return {lines.points[3 * i], lines.points[3 * i + 1], lines.points[3 * i + 2]};
}

/// Arc length of a line's points, the closing segment included.
inline double measure(const Isolines& lines, std::size_t line) {
  const std::size_t begin = at(lines.offsets[line]), end = at(lines.offsets[line + 1]);
  double length = 0;
  for (std::size_t i = begin + 1; i < end; ++i) length += distance(point(lines, i - 1), point(lines, i));
  if (lines.closed[line] != 0) length += distance(point(lines, end - 1), point(lines, begin));
  return length;
}

} // namespace dirichlet
