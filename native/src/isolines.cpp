// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "dirichlet/error.h"
#include "field_checks.h"
#include "index.h"
#include "isoline_tracing.h"
#include "level_numbers.h"
#include "line_geometry.h"
#include "mesh_checks.h"
#include "message.h"
#include "parallel.h"

namespace dirichlet {
namespace {

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

/// Turns half-edges into points. Every line has its own place in the result, so threads may each make some of them.
class LinePlacer {
 public:
  LinePlacer(const Mesh& triangles, std::span<const double> field, Isolines& lines)
      : corners_(triangles.corners()), positions_(triangles.positions()), field_(field), lines_(lines) {}

  /// \returns how many points line `l` has when those that coincide in succession are one. A line that is the same
  /// point all along has none; one that goes to a second point and back, around a plateau that is a single edge, stays
  /// a closed line of two points.
  Index place(std::size_t l, std::span<const Index> half_edges, double level) {
    const std::size_t begin = at(lines_.offsets[l]);
    for (std::size_t done = 0; done < half_edges.size(); done += kBlock)
      place_points(begin + done, half_edges.subspan(done, std::min(kBlock, half_edges.size() - done)), level);
    double length = 0;
    std::size_t end = begin + 1;
    for (std::size_t p = begin + 1; p < begin + half_edges.size(); ++p) {
      if (point(p) == point(end - 1)) continue;
      length += distance(point(end - 1), point(p));
      if (p != end) move(p, end);
      ++end;
    }
    if (lines_.closed[l] != 0) {
      length += distance(point(end - 1), point(begin));
      if (end > begin + 1 && point(end - 1) == point(begin)) --end;
    }
    lines_.length[l] = length;
    return end < begin + 2 ? 0 : static_cast<Index>(end - begin);
  }

 private:
  static constexpr std::size_t kBlock = 128;

  /// Computed from the edge, smaller vertex first, so that both its triangles have the same point bit for bit. First
  /// all ends of a block are fetched, then points are made of them without a branch: one that waits for memory, or goes
  /// another way every time, would hold up those after it.
  void place_points(std::size_t place, std::span<const Index> half_edges, double level) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written before they are read
    std::array<double, 3 * kBlock> from, to, share;
    for (std::size_t k = 0; k < half_edges.size(); ++k) {
      const Index one = corners_[at(half_edges[k])], two = corners_[at(next_in_triangle(half_edges[k]))];
      const Index i = std::min(one, two), j = std::max(one, two);
      const double t = crossing(field_[at(i)], field_[at(j)], level);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        from[3 * k + axis] = positions_[3 * at(i) + axis];
        to[3 * k + axis] = positions_[3 * at(j) + axis];
        share[3 * k + axis] = t;
      }
      lines_.edges[2 * (place + k)] = i;
      lines_.edges[2 * (place + k) + 1] = j;
      lines_.t[place + k] = t;
    }
    double* const points = lines_.points.data() + 3 * place;
    for (std::size_t i = 0; i < 3 * half_edges.size(); ++i) points[i] = between(from[i], to[i], share[i]);
  }

  void move(std::size_t p, std::size_t to) {
    std::copy_n(lines_.points.data() + 3 * p, 3, lines_.points.data() + 3 * to);
    std::copy_n(lines_.edges.data() + 2 * p, 2, lines_.edges.data() + 2 * to);
    lines_.t[to] = lines_.t[p];
  }

  /// Where on the way from `a` to `b` the level between them lies. Distinct doubles never have the difference 0, but
  /// that of two huge ones overflows.
  static double crossing(double a, double b, double level) {
    const double whole = b - a;
    if (std::isfinite(whole)) return (level - a) / whole + 0.0; // 0 for -0
    return (level / 2 - a / 2) / (b / 2 - a / 2);
  }

  [[nodiscard]] Point point(std::size_t i) const { return dirichlet::point(lines_, i); }

  std::span<const Index> corners_;
  std::span<const double> positions_;
  std::span<const double> field_;
  Isolines& lines_;
};

/// Room for the traced lines in `order`.
Isolines room_for(const Traces& traces, std::span<const Index> order, const SortedLevels& levels) {
  Isolines lines;
  lines.points.resize(3 * traces.half_edges.size());
  lines.edges.resize(2 * traces.half_edges.size());
  lines.t.resize(traces.half_edges.size());
  lines.length.resize(order.size());
  lines.offsets.push_back(0);
  for (const Index l : order) {
    lines.offsets.push_back(lines.offsets.back() + traces.offsets[at(l) + 1] - traces.offsets[at(l)]);
    lines.closed.push_back(traces.closed[at(l)]);
    lines.level.push_back(levels.source[at(traces.level[at(l)])]);
  }
  return lines;
}

/// Where lines have become shorter, those after them move up; empty ones go.
void close_gaps(Isolines& lines, std::span<const Index> counts) {
  const std::vector<Index> starts = lines.offsets;
  std::size_t kept = 0;
  Index to = 0;
  for (std::size_t l = 0; l < counts.size(); ++l) {
    if (counts[l] == 0) continue;
    const auto move = [from = starts[l], to, count = counts[l]](auto& values, std::ptrdiff_t width) {
      if (from == to) return; // nothing has gone yet
      const auto first = values.begin() + from * width;
      std::move(first, first + count * width, values.begin() + to * width);
    };
    move(lines.points, 3);
    move(lines.edges, 2);
    move(lines.t, 1);
    lines.closed[kept] = lines.closed[l];
    lines.level[kept] = lines.level[l];
    lines.length[kept] = lines.length[l];
    to += counts[l];
    lines.offsets[++kept] = to;
  }
  lines.points.resize(3 * at(to));
  lines.edges.resize(2 * at(to));
  lines.t.resize(at(to));
  lines.offsets.resize(kept + 1);
  lines.closed.resize(kept);
  lines.level.resize(kept);
  lines.length.resize(kept);
}

} // namespace

Isolines extract_isolines(const Mesh& mesh, std::span<const double> field, std::span<const double> levels,
                          const CancelToken& cancel) {
  check_field(field, mesh.vertex_count());
  const SortedLevels sorted = sort_levels(levels);
  const Mesh& surface = mesh.without_inner_repeats();
  const Mesh& triangles = surface.triangulated();
  const Traces traces = trace_lines(surface, level_numbers(field, sorted.values), cancel);

  std::vector<Index> order(traces.level.size()); // of the levels as the caller has them
  std::iota(order.begin(), order.end(), Index{0});
  const auto source = [&](Index l) { return sorted.source[at(traces.level[at(l)])]; };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return source(a) < source(b); });

  Isolines lines = room_for(traces, order, sorted);
  LinePlacer placer(triangles, field, lines);
  std::vector<Index> counts(order.size());
  constexpr std::size_t kPoints = 1 << 12; // what a thread is worth
  const std::size_t grain = order.size() * kPoints / std::max<std::size_t>(1, traces.half_edges.size()) + 1;
  parallel_chunks(order.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      cancel.check();
      const std::size_t l = at(order[i]);
      const std::span<const Index> half_edges(traces.half_edges.data() + traces.offsets[l],
                                              traces.half_edges.data() + traces.offsets[l + 1]);
      counts[i] = placer.place(i, half_edges, sorted.values[at(traces.level[l])]);
    }
  });
  if (std::accumulate(counts.begin(), counts.end(), std::size_t{0}) < traces.half_edges.size())
    close_gaps(lines, counts);
  if (!std::ranges::all_of(lines.length, [](double length) { return std::isfinite(length); }))
    check_positions(mesh.positions()); // which may have been moved since the mesh was made
  return lines;
}

} // namespace dirichlet
