// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "closest_point.h"
#include "dirichlet/error.h"
#include "message.h"

namespace dirichlet {
namespace {

constexpr Index kMostLevels = 1'000'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check_window(double low, double high) {
  for (const double end : {low, high})
    if (!std::isfinite(end)) throw InputError(message("the window has the end ", end, ", which is not finite"));
  if (!(low < high)) throw InputError(message("the window from ", low, " to ", high, " is empty"));
}

/// Moves ascending levels, as little as possible, to different doubles strictly inside (low, high). \returns false if
/// there are not enough of these.
bool separate(std::vector<double>& levels, double low, double high) {
  double below = low;
  for (double& level : levels) below = level = std::max(level, std::nextafter(below, kInfinity));
  double above = high;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    above = *level = std::min(*level, std::nextafter(above, -kInfinity));
  return levels.front() > low;
}

} // namespace

std::vector<double> even_levels(double low, double high, Index count) {
  check_window(low, high);
  if (count < 1) throw InputError(message("the number of levels is ", count, ", but has to be 1 or more"));
  if (count > kMostLevels) throw InputError(message(count, " levels are more than the ", kMostLevels, " allowed"));
  std::vector<double> spread(static_cast<std::size_t>(count));
  for (Index k = 0; k < count; ++k) spread[static_cast<std::size_t>(k)] = std::lerp(low, high, (k + 0.5) / count);
  std::vector<double> levels = spread;
  if (separate(levels, low, high)) return levels;
  // A window of so few doubles: levels repeat. One that fell on the lower end would lie below everything.
  for (double& level : spread) level = std::max(level, std::nextafter(low, kInfinity));
  return spread;
}

std::vector<double> stepped_levels(double low, double high, double step, double phase) {
  check_window(low, high);
  if (!(step > 0) || !std::isfinite(step)) throw InputError(message("the step is ", step, ", but has to be positive"));
  if (!std::isfinite(phase)) throw InputError(message("the phase is ", phase, ", which is not finite"));
  const double steps = 2 * ((high / 2 - low / 2) / step); // halves, since the width of a huge window overflows
  const auto refuse = [&] {
    throw InputError(message("a step of ", step, " makes more than ", kMostLevels, " levels from ", low, " to ", high));
  };
  if (!(steps <= kMostLevels + 1.0)) refuse();
  const double fraction = phase - std::floor(phase);
  const double first = std::floor(low / step - fraction); // at or below the lower end
  std::vector<double> levels;
  for (Index k = 0; k <= steps + 1; ++k) {
    const double level = (first + k + fraction) * step;
    const double below = levels.empty() ? low : levels.back(); // far from 0, neighbours may round to the same level
    if (level > below && level < high) levels.push_back(level);
  }
  if (levels.size() > kMostLevels) refuse();
  return levels;
}

double level_through_point(const Mesh& mesh, std::span<const double> field, const std::array<double, 3>& point) {
  if (field.size() != static_cast<std::size_t>(mesh.vertex_count()))
    throw InputError(
        message("the field has ", field.size(), " values, but the mesh ", mesh.vertex_count(), " vertices"));
  for (const double x : point)
    if (!std::isfinite(x)) throw InputError(message("the point has the coordinate ", x, ", which is not finite"));

  const SurfacePoint nearest = closest_point(mesh.triangulated(), point);
  double level = 0, low = kInfinity, high = -kInfinity;
  for (std::size_t i = 0; i < 3; ++i) {
    if (nearest.weights[i] == 0) continue; // a vertex that has no part in it may be undefined
    const double value = field[static_cast<std::size_t>(nearest.vertices[i])];
    if (!std::isfinite(value))
      throw InputError(message("the field is ", value, " at vertex ", nearest.vertices[i], ", next to the point"));
    level += nearest.weights[i] * value;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return std::clamp(level, low, high); // weights that are rounded may sum to a little more than 1
}

} // namespace dirichlet
