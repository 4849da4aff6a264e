// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_checks.h"

#include <cmath>

#include "any_value.h"
#include "dirichlet/error.h"
#include "index.h"
#include "message.h"

namespace dirichlet {

void check_lines(const Isolines& lines) {
  const std::size_t count = lines.closed.size();
  const auto& offsets = lines.offsets;
  if (offsets.size() != count + 1 || lines.level.size() != count || lines.length.size() != count)
    throw InputError(message(count, " lines have ", offsets.size(), " offsets, ", lines.level.size(), " levels and ",
                             lines.length.size(), " lengths, which do not fit together"));
  if (offsets.front() != 0 || offsets.back() < 0 || 3 * at(offsets.back()) != lines.points.size())
    throw InputError(message("the lines' offsets run from ", offsets.front(), " to ", offsets.back(),
                             ", but there are ", lines.points.size(), " coordinates of points"));
  for (std::size_t l = 0; l < count; ++l)
    if (offsets[l + 1] < offsets[l] + 2) throw InputError(message("line ", l, " has fewer than two points"));
  const std::size_t points = at(offsets.back());
  const bool without = lines.edges.empty() && lines.t.empty();
  if (!without && (lines.edges.size() != 2 * points || lines.t.size() != points))
    throw InputError(message(points, " points have ", lines.edges.size(), " ends of edges and ", lines.t.size(),
                             " places on edges, which do not fit together"));
  if (any_value(lines.points, [](double x) { return !std::isfinite(x); }))
    throw InputError("the lines have a coordinate that is not finite");
}

void check_edges(const Isolines& lines, Index vertex_count) {
  check_lines(lines);
  if (lines.t.empty() && !lines.points.empty())
    throw InputError("the lines have been resampled: their points lie on no edges any more");
  for (std::size_t i = 0; i < lines.edges.size(); ++i)
    if (const Index v = lines.edges[i]; v < 0 || v >= vertex_count)
      throw InputError(
          message("point ", i / 2, " lies on an edge of vertex ", v, ", but the vertices are 0 to ", vertex_count - 1));
  if (any_value(lines.t, [](double t) { return !(t >= 0 && t <= 1); }))
    throw InputError("the lines have a place t outside 0 to 1");
}

} // namespace dirichlet
