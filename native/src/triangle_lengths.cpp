// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_lengths.h"

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace dirichlet {
namespace {

/// Brings lengths to where their fourth powers are ordinary numbers; hardly ever there is something to do.
Sides ordinary(Sides sides) {
  const double longest = std::max({sides[0], sides[1], sides[2]});
  if (longest > 1e-70 && longest < 1e70) return sides;
  const double scale = unit_scale(longest);
  for (double& side : sides) side *= scale;
  return sides;
}

/// Four times the area, of ordinary lengths.
double four_areas(const Sides& sides) {
  const double low = std::min(sides[0], sides[1]), high = std::max(sides[0], sides[1]);
  const double a = std::max(high, sides[2]), c = std::min(low, sides[2]);
  const double b = std::max(low, std::min(high, sides[2]));
  return std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))));
}

} // namespace

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

} // namespace dirichlet
