// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/line_shaping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "dirichlet/error.h"
#include "index.h"
#include "line_checks.h"
#include "line_geometry.h"
#include "line_simplifier.h"
#include "line_smoother.h"
#include "message.h"
#include "parallel.h"

namespace dirichlet {
namespace {

constexpr std::size_t kLineGrain = 1 << 6; ///< lines that a thread is worth

void check_not_negative(double value, const char* what) {
  if (!(value >= 0)) throw InputError(message("the ", what, " is ", value, ", but has to be 0 or more"));
}

template <class T>
void select(const T& from, std::span<const Index> places, std::size_t width, T& to) {
  if (from.empty()) return;
  to.reserve(width * places.size());
  for (const Index place : places)
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(width * at(place)),
              from.begin() + static_cast<std::ptrdiff_t>(width * at(place) + width));
}

/// Some of the lines, each with some of its points.
/// \param points   (P',) numbers of points, in order
/// \param offsets  (L' + 1,) where the lines start among them
/// \param numbers  (L',) of the lines
Isolines part_of(const Isolines& lines, std::span<const Index> points, std::vector<Index> offsets,
                 std::span<const Index> numbers) {
  Isolines part;
  select(lines.points, points, 3, part.points);
  select(lines.edges, points, 2, part.edges);
  select(lines.t, points, 1, part.t);
  select(lines.closed, numbers, 1, part.closed);
  select(lines.level, numbers, 1, part.level);
  select(lines.length, numbers, 1, part.length);
  part.offsets = std::move(offsets);
  return part;
}

template <class F>
void for_lines(const Isolines& lines, const CancelToken& cancel, const F& f) {
  parallel_chunks(lines.closed.size(), kLineGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l) {
      cancel.check();
      f(l);
    }
  });
}

void measure_all(Isolines& lines, const CancelToken& cancel = {}) {
  for_lines(lines, cancel, [&](std::size_t l) { lines.length[l] = measure(lines, l); });
}

/// How many segments a line is to have.
double segment_count(bool closed, double length, double spacing) {
  return std::max(std::round(length / spacing), closed ? 3.0 : 1.0);
}

/// Writes `segments` steps along a line of this length, and its end if it is open.
void walk(const Isolines& lines, std::size_t line, double length, Index segments, double* to) {
  const std::size_t begin = at(lines.offsets[line]), end = at(lines.offsets[line + 1]);
  const auto corner = [&](std::size_t i) { return point(lines, i == end ? begin : i); };
  const std::size_t last = lines.closed[line] != 0 ? end : end - 1;
  std::size_t i = begin; // on the segment from i to i + 1, which starts `passed` from the line's start
  double passed = 0, segment = distance(corner(i), corner(i + 1));
  for (Index k = 0; k < segments; ++k) {
    const double place = length * (static_cast<double>(k) / segments);
    while (passed + segment < place && i + 1 < last) {
      passed += segment;
      ++i;
      segment = distance(corner(i), corner(i + 1));
    }
    const double t = segment > 0 ? std::clamp((place - passed) / segment, 0.0, 1.0) : 0.0;
    const Point a = corner(i), b = corner(i + 1);
    for (std::size_t axis = 0; axis < 3; ++axis) *to++ = between(a[axis], b[axis], t);
  }
  if (lines.closed[line] == 0) std::ranges::copy(point(lines, end - 1), to);
}

} // namespace

Isolines keep_long(const Isolines& lines, double least) {
  check_lines(lines);
  check_not_negative(least, "least length");
  std::vector<Index> points, offsets{0}, numbers;
  for (std::size_t l = 0; l < lines.closed.size(); ++l) {
    if (!(lines.length[l] >= least)) continue;
    for (Index i = lines.offsets[l]; i < lines.offsets[l + 1]; ++i) points.push_back(i);
    offsets.push_back(static_cast<Index>(points.size()));
    numbers.push_back(static_cast<Index>(l));
  }
  return part_of(lines, points, std::move(offsets), numbers);
}

Isolines smooth_lines(const Mesh& mesh, Isolines lines, Index steps, const CancelToken& cancel) {
  constexpr Index kMostSteps = 10'000;
  if (steps < 0 || steps > kMostSteps)
    throw InputError(message("the number of steps is ", steps, ", but has to be from 0 to ", kMostSteps));
  check_edges(lines, mesh.vertex_count());
  if (steps == 0) return lines;
  const LineSmoother smoother(mesh.positions(), lines);
  for_lines(lines, cancel, [&](std::size_t l) { smoother.smooth(l, steps, cancel, lines); });
  return move_lines(std::move(lines), mesh.positions());
}

Isolines simplify_lines(const Isolines& lines, double tolerance, const CancelToken& cancel) {
  check_lines(lines);
  check_not_negative(tolerance, "tolerance");
  const LineSimplifier simplifier(lines, tolerance);
  std::vector<std::uint8_t> kept(at(lines.offsets.back()));
  for_lines(lines, cancel, [&](std::size_t l) { simplifier.mark(l, cancel, kept); });
  std::vector<Index> points, offsets{0}, numbers(lines.closed.size());
  for (std::size_t l = 0; l < numbers.size(); ++l) {
    for (Index i = lines.offsets[l]; i < lines.offsets[l + 1]; ++i)
      if (kept[at(i)] != 0) points.push_back(i);
    offsets.push_back(static_cast<Index>(points.size()));
  }
  std::iota(numbers.begin(), numbers.end(), Index{0});
  Isolines simple = part_of(lines, points, std::move(offsets), numbers);
  measure_all(simple, cancel);
  return simple;
}

Isolines resample_lines(const Isolines& lines, double spacing, const CancelToken& cancel) {
  check_lines(lines);
  if (!(spacing > 0) || !std::isfinite(spacing))
    throw InputError(message("the spacing is ", spacing, ", but has to be positive"));
  const std::size_t count = lines.closed.size();
  std::vector<double> lengths(count);
  for_lines(lines, cancel, [&](std::size_t l) { lengths[l] = measure(lines, l); });
  std::vector<Index> segments, offsets{0};
  constexpr double kMostPoints = 1 << 30;
  for (std::size_t l = 0; l < count; ++l) {
    const bool closed = lines.closed[l] != 0;
    const double here = segment_count(closed, lengths[l], spacing), all = offsets.back() + here + (closed ? 0 : 1);
    if (!(all < kMostPoints)) throw InputError(message("a spacing of ", spacing, " makes 2^30 points or more"));
    segments.push_back(static_cast<Index>(here));
    offsets.push_back(static_cast<Index>(all));
  }
  Isolines even{{}, {}, {}, offsets, lines.closed, lines.level, lengths};
  even.points.resize(3 * at(offsets.back()));
  for_lines(lines, cancel,
            [&](std::size_t l) { walk(lines, l, lengths[l], segments[l], even.points.data() + 3 * at(offsets[l])); });
  measure_all(even, cancel);
  return even;
}

Isolines move_lines(Isolines lines, std::span<const double> positions) {
  if (positions.size() % 3 != 0)
    throw InputError(message("positions have ", positions.size(), " numbers, which is not a multiple of 3"));
  check_edges(lines, static_cast<Index>(positions.size() / 3));
  for (std::size_t i = 0; i < lines.t.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = positions[3 * at(lines.edges[2 * i]) + axis];
      const double b = positions[3 * at(lines.edges[2 * i + 1]) + axis];
      if (!std::isfinite(a) || !std::isfinite(b))
        throw InputError(message("vertex ", lines.edges[2 * i + (std::isfinite(a) ? 1 : 0)],
                                 " has a coordinate that is not finite"));
      lines.points[3 * i + axis] = between(a, b, lines.t[i]);
    }
  measure_all(lines);
  return lines;
}

} // namespace dirichlet
