// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <numeric>

#include "dirichlet/error.h"
#include "isoline_tracing.h"
#include "message.h"
#include "parallel.h"

namespace dirichlet {
namespace {

using Point = std::array<double, 3>;

/// The distinct levels, ascending, and where the caller has them first.
struct SortedLevels {
  std::vector<double> values;
  std::vector<Index> source;
};

SortedLevels sort_levels(std::span<const double> levels) {
  const auto bad = [](double level) { return !std::isfinite(level); };
  const auto first = std::find_if(levels.begin(), levels.end(), bad);
  if (first != levels.end())
    throw InputError(message("level ", first - levels.begin(), " is ", *first, ", which is not finite",
                             and_more(std::count_if(first, levels.end(), bad) - 1, "level")));
  std::vector<Index> order(levels.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto value = [&](Index i) { return levels[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return value(a) < value(b); });
  const auto same = [&](Index a, Index b) { return value(a) == value(b); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  SortedLevels sorted;
  for (const Index i : order) sorted.values.push_back(value(i));
  sorted.source = std::move(order);
  return sorted;
}

void check_field(std::span<const double> field, Index vertex_count) {
  if (field.size() != static_cast<std::size_t>(vertex_count))
    throw InputError(message("the field has ", field.size(), " values, but the mesh ", vertex_count, " vertices"));
  const auto bad = [](double value) { return std::isinf(value); };
  const auto first = std::find_if(field.begin(), field.end(), bad);
  if (first == field.end()) return;
  throw InputError(message("the field is infinite at vertex ", first - field.begin(),
                           and_more(std::count_if(first, field.end(), bad) - 1, "value")));
}

/// How many of the ascending levels are <= value. A binary search in which only a factor depends on the outcome:
/// a branch would be mispredicted every other time.
Index level_number(std::span<const double> levels, double value) {
  if (std::isnan(value)) return kUndefined;
  const double* base = levels.data();
  for (std::size_t size = levels.size(); size > 0;) {
    const std::size_t half = (size + 1) / 2;
    base += static_cast<std::size_t>(base[half - 1] <= value) * half;
    size -= half;
  }
  return static_cast<Index>(base - levels.data());
}

std::vector<Index> level_numbers(std::span<const double> field, std::span<const double> levels) {
  std::vector<Index> numbers(field.size());
  parallel_chunks(field.size(), std::size_t{1} << 15, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) numbers[v] = level_number(levels, field[v]);
  });
  return numbers;
}

/// Squares of the usual lengths are the quick way; those that would vanish take the long one.
double distance(const Point& a, const Point& b) {
  const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  const double squared = x * x + y * y + z * z;
  return squared > 1e-280 ? std::sqrt(squared) : std::hypot(x, y, z);
}

/// Turns half-edges into points, and collects lines.
class LineBuilder {
 public:
  LineBuilder(const Mesh& triangles, std::span<const double> field)
      : corners_(triangles.corners()), positions_(triangles.positions()), field_(field) {
    lines_.offsets.push_back(0);
  }

  /// A line that is the same point all along leaves nothing. One that goes to a second point and back, around a plateau
  /// that is a single edge, stays a closed line of two points.
  void add(std::span<const Index> half_edges, bool closed, double level, Index level_index) {
    const auto begin = static_cast<std::size_t>(lines_.offsets.back());
    double length = 0;
    for (const Index half_edge : half_edges) {
      const bool first = lines_.t.size() == begin;
      add_point(half_edge, level);
      const std::size_t last = lines_.t.size() - 1;
      if (first) continue;
      if (point(last) == point(last - 1))
        resize(last);
      else
        length += distance(point(last - 1), point(last));
    }
    if (closed) length += close(begin);
    if (lines_.t.size() < begin + 2) return resize(begin);
    lines_.offsets.push_back(static_cast<Index>(lines_.t.size()));
    lines_.closed.push_back(closed ? 1 : 0);
    lines_.level.push_back(level_index);
    lines_.length.push_back(length);
  }

  Isolines take() { return std::move(lines_); }

 private:
  /// Takes away a last point that is the first one again. \returns by how much the line gets longer.
  double close(std::size_t begin) {
    const std::size_t last = lines_.t.size() - 1;
    const double length = distance(point(last), point(begin));
    if (last > begin && point(last) == point(begin)) resize(last);
    return length;
  }

  /// Computed from the edge, smaller vertex first, so that both its triangles have the same point bit for bit;
  /// std::lerp is exact at both ends, and never outside them.
  void add_point(Index half_edge, double level) {
    const Index other = half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
    const auto [i, j] =
        std::minmax(corners_[static_cast<std::size_t>(half_edge)], corners_[static_cast<std::size_t>(other)]);
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const double t = crossing(field_[a], field_[b], level);
    for (std::size_t axis = 0; axis < 3; ++axis)
      lines_.points.push_back(std::lerp(positions_[3 * a + axis], positions_[3 * b + axis], t));
    lines_.edges.push_back(i);
    lines_.edges.push_back(j);
    lines_.t.push_back(t);
  }

  /// Where on the way from `a` to `b` the level between them lies. Distinct doubles never have the difference 0, but
  /// that of two huge ones overflows.
  static double crossing(double a, double b, double level) {
    const double whole = b - a;
    if (std::isfinite(whole)) return (level - a) / whole + 0.0; // 0 for -0
    return (level / 2 - a / 2) / (b / 2 - a / 2);
  }

  [[nodiscard]] Point point(std::size_t i) const {
    return {lines_.points[3 * i], lines_.points[3 * i + 1], lines_.points[3 * i + 2]};
  }

  void resize(std::size_t count) {
    lines_.points.resize(3 * count);
    lines_.edges.resize(2 * count);
    lines_.t.resize(count);
  }

  std::span<const Index> corners_;
  std::span<const double> positions_;
  std::span<const double> field_;
  Isolines lines_;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void append(Isolines& lines, const Isolines& more) {
  const Index shift = lines.offsets.back();
  append(lines.points, more.points);
  append(lines.edges, more.edges);
  append(lines.t, more.t);
  for (std::size_t l = 1; l < more.offsets.size(); ++l) lines.offsets.push_back(shift + more.offsets[l]);
  append(lines.closed, more.closed);
  append(lines.level, more.level);
  append(lines.length, more.length);
}

/// Ranks of the levels in the order in which the caller has them.
std::vector<Index> callers_order(const SortedLevels& levels) {
  std::vector<Index> order(levels.values.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto source = [&](Index rank) { return levels.source[static_cast<std::size_t>(rank)]; };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return source(a) < source(b); });
  return order;
}

} // namespace

Isolines extract_isolines(const Mesh& mesh, std::span<const double> field, std::span<const double> levels) {
  check_field(field, mesh.vertex_count());
  const SortedLevels sorted = sort_levels(levels);
  const Mesh& triangles = mesh.triangulated();
  const std::vector<Index> numbers = level_numbers(field, sorted.values);
  const auto level_count = sorted.values.size();
  const Crossings crossings = find_crossings(triangles.corners(), numbers, static_cast<Index>(level_count));

  const std::vector<Index> order = callers_order(sorted);
  std::map<std::size_t, Isolines> pieces; // by the place in `order` where they begin
  std::mutex mutex;
  constexpr std::size_t kCrossings = 1 << 13; // what a thread and its marks are worth
  const std::size_t grain = level_count * kCrossings / std::max<std::size_t>(1, crossings.triangles.size()) + 1;
  parallel_chunks(level_count, grain, [&](std::size_t begin, std::size_t end) {
    LineTracer tracer(mesh, numbers);
    LineBuilder builder(triangles, field);
    std::vector<Index> half_edges;
    for (std::size_t i = begin; i < end; ++i) {
      const auto rank = static_cast<std::size_t>(order[i]);
      const auto first = static_cast<std::size_t>(crossings.offsets[rank]);
      const auto last = static_cast<std::size_t>(crossings.offsets[rank + 1]);
      for (std::size_t c = first; c < last; ++c) {
        if (tracer.visited(crossings.triangles[c], order[i])) continue;
        const bool closed = tracer.trace(crossings.triangles[c], order[i], half_edges);
        builder.add(half_edges, closed, sorted.values[rank], sorted.source[rank]);
      }
    }
    const std::scoped_lock lock(mutex);
    pieces.emplace(begin, builder.take());
  });
  Isolines lines = std::move(pieces.begin()->second);
  for (auto piece = std::next(pieces.begin()); piece != pieces.end(); ++piece) append(lines, piece->second);
  return lines;
}

} // namespace dirichlet
