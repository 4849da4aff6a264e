// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_simplifier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "index.h"

namespace dirichlet {
namespace {

/// From the origin to the segment from a to b, squared.
double squared_distance(const Vector3& a, const Vector3& b) {
  const Vector3 way = b - a;
  const double squared = dot(way, way);
  const Vector3 nearest = squared > 0 ? a + std::clamp(-dot(a, way) / squared, 0.0, 1.0) * way : a;
  return dot(nearest, nearest);
}

double largest(std::span<const double> numbers) {
  double size = 0;
  for (const double x : numbers) size = std::max(size, std::abs(x));
  return size;
}

} // namespace

LineSimplifier::LineSimplifier(const Isolines& lines, double tolerance)
    : lines_(lines), scale_(unit_scale(largest(lines.points))), tolerance_(tolerance * scale_) {}

Vector3 LineSimplifier::point(std::size_t i) const {
  const double* p = lines_.points.data() + 3 * i;
  return scale_ * Vector3{p[0], p[1], p[2]};
}

/// The point between `first` and `last` that is farthest from the segment from `first` to `end`; `first` itself where
/// there is none.
LineSimplifier::Farthest LineSimplifier::farthest(std::size_t first, std::size_t last, std::size_t end) const {
  Farthest worst{-1, first};
  const Vector3 a = point(first), b = point(end);
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vector3 p = point(i);
    if (const double squared = squared_distance(a - p, b - p); squared > worst.first) worst = {squared, i};
  }
  worst.first = std::sqrt(std::max(0.0, worst.first));
  return worst;
}

/// \param end  the point that follows last - 1: `last` itself, or the line's first if it closes there
void LineSimplifier::mark_between(std::size_t first, std::size_t last, std::size_t end, const CancelToken& cancel,
                                  std::vector<std::uint8_t>& kept) const {
  std::vector<std::array<std::size_t, 3>> parts{{first, last, end}};
  while (!parts.empty()) {
    cancel.check();
    const auto [from, to, to_point] = parts.back();
    parts.pop_back();
    const auto [distance, middle] = farthest(from, to, to_point);
    if (!(distance > tolerance_)) continue;
    kept[middle] = 1;
    parts.push_back({from, middle, middle});
    parts.push_back({middle, to, to_point});
  }
}

void LineSimplifier::mark(std::size_t l, const CancelToken& cancel, std::vector<std::uint8_t>& kept) const {
  const std::size_t begin = at(lines_.offsets[l]), end = at(lines_.offsets[l + 1]);
  kept[begin] = 1;
  if (lines_.closed[l] == 0) {
    kept[end - 1] = 1;
    mark_between(begin, end - 1, end - 1, cancel, kept);
    return;
  }
  // A closed line falls into two at the point farthest from its first one.
  const std::size_t middle = std::max(begin + 1, farthest(begin, end, begin).second);
  kept[middle] = 1;
  mark_between(begin, middle, middle, cancel, kept);
  mark_between(middle, end, begin, cancel, kept);
  if (end - begin < 3 || std::count(kept.begin() + static_cast<std::ptrdiff_t>(begin),
                                    kept.begin() + static_cast<std::ptrdiff_t>(end), 1) > 2)
    return;
  const Farthest there = farthest(begin, middle, middle), back = farthest(middle, end, begin);
  const bool on_way_back = middle == begin + 1 || (end > middle + 1 && back.first > there.first);
  kept[on_way_back ? back.second : there.second] = 1;
}

} // namespace dirichlet
