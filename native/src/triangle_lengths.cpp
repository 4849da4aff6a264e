// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_lengths.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "index.h"
#include "parallel.h"
#include "vector3.h"

namespace dirichlet {
namespace {

/// What a longest side has to fall short by, relative: far above the rounding of lengths, far below what a field shows.
constexpr double kSlack = 1e-12;
constexpr std::size_t kGrain = 1 << 13;

/// Brings lengths to where their fourth powers are ordinary numbers; hardly ever there is something to do.
Sides ordinary(Sides sides) {
  const double longest = std::max({sides[0], sides[1], sides[2]});
  if (longest > 1e-70 && longest < 1e70) return sides;
  const double scale = unit_scale(longest);
  for (double& side : sides) side *= scale;
  return sides;
}

/// How much the longest side falls short of the sum of the others.
struct Slack {
  double longest, amount;
};

Slack slack_of(Sides sides) {
  std::sort(sides.begin(), sides.end());
  return {sides[2], sides[0] - (sides[2] - sides[1])};
}

/// Four times the area, of ordinary lengths.
double four_areas(const Sides& sides) {
  const double low = std::min(sides[0], sides[1]), high = std::max(sides[0], sides[1]);
  const double a = std::max(high, sides[2]), c = std::min(low, sides[2]);
  const double b = std::max(low, std::min(high, sides[2]));
  return std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))));
}

double distance(const double* p, const double* q, double scale) {
  const double x = scale * (p[0] - q[0]), y = scale * (p[1] - q[1]), z = scale * (p[2] - q[2]);
  const double square = x * x + y * y + z * z;
  constexpr double kExact = 1e-280; // below, squares lose digits
  return square > kExact ? std::sqrt(square) : std::hypot(x, y, z);
}

/// The widest side of the bounding box of what has faces.
double extent(const Mesh& mesh) {
  const std::span<const Index> corners = mesh.corners();
  const double* const p = mesh.positions().data();
  const auto start = 3 * at(corners[0]);
  std::array<double, 3> low{p[start], p[start + 1], p[start + 2]}, high = low;
  std::mutex mutex;
  parallel_chunks(corners.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::array<double, 3> lowest{low}, highest{lowest};
    for (std::size_t c = begin; c < end; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = p[3 * at(corners[c]) + k];
        lowest[k] = std::min(lowest[k], x);
        highest[k] = std::max(highest[k], x);
      }
    const std::scoped_lock lock(mutex);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], lowest[k]);
      high[k] = std::max(high[k], highest[k]);
    }
  });
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

} // namespace

double triangle_area(const Sides& sides) {
  const double scale = unit_scale(std::max({sides[0], sides[1], sides[2]}));
  return four_areas({scale * sides[0], scale * sides[1], scale * sides[2]}) / 4 / scale / scale;
}

Sides half_cotangents(const Sides& sides) {
  const auto [a, b, c] = ordinary(sides);
  const double eight_areas = 2 * four_areas({a, b, c});
  // y² + z² − x², above 0 whatever is rounded unless x is the longest.
  const auto numerator = [](double x, double y, double z) {
    const double short_one = std::min(y, z), long_one = std::max(y, z);
    return short_one * short_one + (long_one - x) * (long_one + x);
  };
  return {numerator(a, b, c) / eight_areas, numerator(b, c, a) / eight_areas, numerator(c, a, b) / eight_areas};
}

double mollification(const Sides& sides) {
  const auto [longest, slack] = slack_of(sides);
  return slack >= kSlack * longest ? 0.0 : (kSlack * longest - slack) / (1 - kSlack);
}

Sides mollified(const Sides& sides) {
  if (std::max({sides[0], sides[1], sides[2]}) == 0) return {1, 1, 1};
  const double more = mollification(sides);
  return {sides[0] + more, sides[1] + more, sides[2] + more};
}

Sides SideLengths::of(Index face) const {
  const auto side = 3 * at(face);
  return {lengths[side] + mollification, lengths[side + 1] + mollification, lengths[side + 2] + mollification};
}

SideLengths measure_sides(const Mesh& triangles) {
  const std::span<const Index> corners = triangles.corners();
  const double* const p = triangles.positions().data();
  const double scale = unit_scale(extent(triangles));
  SideLengths sides;
  sides.unit = 1 / scale;
  sides.lengths.resize(corners.size());
  bool points = false; // triangles without extent
  std::mutex mutex;
  parallel_chunks(at(triangles.face_count()), kGrain, [&](std::size_t begin, std::size_t end) {
    double largest = 0;
    bool any_point = false;
    std::ptrdiff_t count = 0;
    for (std::size_t c = 3 * begin; c < 3 * end; c += 3) {
      const double *const i = p + 3 * at(corners[c]), *const j = p + 3 * at(corners[c + 1]),
                          *const k = p + 3 * at(corners[c + 2]);
      const Sides of_face{distance(i, j, scale), distance(j, k, scale), distance(k, i, scale)};
      std::copy(of_face.begin(), of_face.end(), sides.lengths.begin() + static_cast<std::ptrdiff_t>(c));
      const auto [longest, slack] = slack_of(of_face);
      if (slack >= kSlack * longest && longest > 0) continue;
      ++count;
      any_point |= longest == 0;
      largest = std::max(largest, mollification(of_face));
    }
    const std::scoped_lock lock(mutex);
    sides.mollification = std::max(sides.mollification, largest);
    sides.mollified += count;
    points |= any_point;
  });
  if (points) sides.mollification = std::max(sides.mollification, kSlack); // of the extent, which is about 1
  return sides;
}

} // namespace dirichlet
