// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "closest_point.h"
#include "dirichlet/error.h"
#include "field_checks.h"
#include "index.h"
#include "mesh_checks.h"
#include "message.h"
#include "strips.h"

namespace dirichlet {
namespace {

constexpr Index kMostLevels = 1'000'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check_window(double low, double high) {
  for (const double end : {low, high})
    if (!std::isfinite(end)) throw InputError(message("the window has the end ", end, ", which is not finite"));
  if (!(low < high)) throw InputError(message("the window from ", low, " to ", high, " is empty"));
}

void check_count(Index count) {
  if (count < 1) throw InputError(message("the number of levels is ", count, ", but has to be 1 or more"));
  if (count > kMostLevels) throw InputError(message(count, " levels are more than the ", kMostLevels, " allowed"));
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

/// The part of the surface that levels are spread over.
struct Window {
  const Mesh& triangles;
  std::span<const double> field;
  double low, high;
};

Window open_window(const Mesh& mesh, std::span<const double> field, Index count, std::optional<double> low,
                   std::optional<double> high) {
  check_count(count);
  check_field(field, mesh.vertex_count());
  check_positions(mesh.positions()); // which may have been moved since the mesh was made
  if (low && high) check_window(*low, *high);
  const Mesh& triangles = mesh.without_repeats().triangulated();
  double least = kInfinity, greatest = -kInfinity;
  for (std::size_t c = 0; c < triangles.corners().size(); c += 3) {
    const auto value = [&](std::size_t i) { return field[at(triangles.corners()[c + i])]; };
    const double a = value(0), b = value(1), d = value(2);
    if (std::isnan(a) || std::isnan(b) || std::isnan(d) || (a == b && b == d)) continue;
    least = std::min({least, a, b, d});
    greatest = std::max({greatest, a, b, d});
  }
  if (!(least < greatest)) throw InputError("the field is constant on every triangle where it has values");
  const Window window{triangles, field, low.value_or(least), high.value_or(greatest)};
  check_window(window.low, window.high);
  if (window.high <= least || window.low >= greatest)
    throw InputError(message("the window from ", window.low, " to ", window.high, " holds none of the field's range ",
                             least, " to ", greatest));
  return window;
}

/// Refuses a window that has no quantity of what its levels share out.
void check_share(const Window& window, const std::vector<double>& quantity) {
  if (quantity.back() > 0) return;
  throw InputError(message("the surface has no area from ", window.low, " to ", window.high,
                           " of the field, which levels could share out"));
}

/// At least kSamples steps from low to high, none longer than an even one, and small where many vertices have their
/// values: these alone would leave long steps to large triangles, whose vertices are few.
std::vector<double> sample(const Window& window) {
  constexpr std::size_t kSamples = 1 << 10, kEnough = 1 << 16;
  std::vector<double> values{window.low, window.high};
  for (std::size_t v = 0; v < window.field.size(); v += window.field.size() / kEnough + 1)
    if (const double value = window.field[v]; window.low < value && value < window.high) values.push_back(value);
  std::sort(values.begin(), values.end());
  const std::size_t last = values.size() - 1, steps = std::min(last, kSamples), parts = (kSamples - 1) / steps + 1;
  std::vector<double> samples{window.low};
  const auto add = [&](double from, double to, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i)
      samples.push_back(std::lerp(from, to, static_cast<double>(i) / static_cast<double>(count)));
  };
  for (std::size_t i = 0; i < steps; ++i) add(values[last * i / steps], values[last * (i + 1) / steps], parts);
  add(window.low, window.high, kSamples);
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  return samples;
}

/// Where a quantity that ascends over the samples has gone k + 1 of count + 1 equal steps: the number of the first
/// sample beyond, and the quantity there.
std::vector<std::pair<std::size_t, double>> equal_steps(std::span<const double> quantity, Index count) {
  std::vector<std::pair<std::size_t, double>> steps;
  std::size_t j = 1;
  for (Index k = 0; k < count; ++k) {
    const double goal = std::lerp(quantity.front(), quantity.back(), (k + 1.0) / (count + 1.0));
    while (j + 1 < quantity.size() && quantity[j] < goal) ++j;
    steps.emplace_back(j, goal);
  }
  return steps;
}

/// x from low to high for y from y_low to y_high.
double interpolate(double low, double high, double y_low, double y_high, double y) {
  return y_high > y_low ? std::lerp(low, high, std::clamp((y - y_low) / (y_high - y_low), 0.0, 1.0)) : low;
}

/// A level that is looked for, between two others.
struct Bracket {
  double low, high, area_low, area_high, goal;
};

/// What neighbours of greater and smaller goals know, so that the ends of all brackets ascend.
void share(std::vector<Bracket>& brackets) {
  for (std::size_t k = 1; k < brackets.size(); ++k) {
    Bracket &bracket = brackets[k], &before = brackets[k - 1];
    if (before.low > bracket.low) std::tie(bracket.low, bracket.area_low) = std::tie(before.low, before.area_low);
  }
  for (std::size_t k = brackets.size(); --k > 0;) {
    Bracket &bracket = brackets[k - 1], &after = brackets[k];
    if (after.high < bracket.high) std::tie(bracket.high, bracket.area_high) = std::tie(after.high, after.area_high);
  }
}

} // namespace

std::vector<double> even_levels(double low, double high, Index count) {
  check_window(low, high);
  check_count(count);
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

std::vector<double> equal_area_levels(const Mesh& mesh, std::span<const double> field, Index count,
                                      std::optional<double> low, std::optional<double> high,
                                      const CancelToken& cancel) {
  const Window window = open_window(mesh, field, count, low, high);
  const std::vector<double> samples = sample(window),
                            areas = measure_strips(window.triangles, field, samples, cancel).area;
  check_share(window, areas);
  std::vector<Bracket> brackets;
  for (const auto& [j, goal] : equal_steps(areas, count))
    brackets.push_back({samples[j - 1], samples[j], areas[j - 1], areas[j], goal});
  std::vector<double> levels(brackets.size());
  const double close = 1e-12 * areas.back();
  constexpr int kMostPasses = 100;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    double before = window.low; // strips are measured of levels that ascend
    std::transform(brackets.begin(), brackets.end(), levels.begin(), [&](const Bracket& b) { // by halves now and then
      const double level =
          pass % 3 == 2 ? std::midpoint(b.low, b.high) : interpolate(b.low, b.high, b.area_low, b.area_high, b.goal);
      return before = std::clamp(std::max(level, before), b.low, b.high);
    });
    const Strips strips = measure_strips(window.triangles, field, levels, cancel);
    bool done = true;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      Bracket& bracket = brackets[k];
      const double level = levels[k], area = strips.area[k];
      done = done && (std::abs(area - bracket.goal) <= close || level == bracket.low || level == bracket.high);
      if (area < bracket.goal) {
        bracket.low = level;
        bracket.area_low = area;
      } else {
        bracket.high = level;
        bracket.area_high = area;
      }
    }
    if (done) break;
    share(brackets);
  }
  return levels;
}

std::vector<double> equal_distance_levels(const Mesh& mesh, std::span<const double> field, Index count,
                                          std::optional<double> low, std::optional<double> high,
                                          const CancelToken& cancel) {
  const Window window = open_window(mesh, field, count, low, high);
  const std::vector<double> samples = sample(window);
  const Strips strips = measure_strips(window.triangles, field, samples, cancel);
  std::vector<double> advance{0}; // of the lines, on average, from the window's lower end
  for (std::size_t j = 1; j < samples.size(); ++j) {
    const double area = strips.area[j] - strips.area[j - 1], length = (strips.after[j - 1] + strips.before[j]) / 2;
    advance.push_back(advance.back() + (area > 0 && length > 0 ? area / length : 0));
  }
  check_share(window, advance);
  std::vector<double> levels;
  for (const auto& [j, goal] : equal_steps(advance, count))
    levels.push_back(interpolate(samples[j - 1], samples[j], advance[j - 1], advance[j], goal));
  return levels;
}

double level_through_point(const Mesh& mesh, std::span<const double> field, const std::array<double, 3>& point) {
  check_field_size(field, mesh.vertex_count());
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
