// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_smoother.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "index.h"
#include "vector3.h"

namespace dirichlet {
namespace {

/// A point that slides on its edge.
struct Bead {
  Vector3 start, edge;
  double squared; ///< of the edge's length
  double t, least, most;

  [[nodiscard]] Vector3 place() const { return start + t * edge; }

  /// Where it makes the way from `one` to `two` shortest: each pulls with the other's distance from the edge.
  [[nodiscard]] double goal(const Vector3& one, const Vector3& two) const {
    const auto [t_one, away_one] = seen_from_edge(one - start);
    const auto [t_two, away_two] = seen_from_edge(two - start);
    const double away = away_one + away_two;
    return away > 0 ? t_one + (t_two - t_one) * (away_one / away) : t;
  }

 private:
  [[nodiscard]] std::pair<double, double> seen_from_edge(const Vector3& p) const {
    const double along = dot(p, edge) / squared;
    const Vector3 across = p - along * edge;
    return {along, std::sqrt(dot(across, across))};
  }
};

} // namespace

LineSmoother::LineSmoother(std::span<const double> positions, const Isolines& lines) : positions_(positions) {
  double size = 0;
  for (const Index v : lines.edges)
    for (std::size_t axis = 0; axis < 3; ++axis) size = std::max(size, std::abs(positions[3 * at(v) + axis]));
  scale_ = unit_scale(size);
}

void LineSmoother::smooth(std::size_t l, Index steps, const CancelToken& cancel, Isolines& lines) const {
  constexpr double kRoom = 0.01; // that a point leaves before a vertex
  const std::size_t begin = at(lines.offsets[l]), count = at(lines.offsets[l + 1]) - begin;
  const auto scaled = [&](Index v) {
    const double* p = positions_.data() + 3 * at(v);
    return scale_ * Vector3{p[0], p[1], p[2]};
  };
  std::vector<Bead> beads;
  for (std::size_t i = begin; i < begin + count; ++i) {
    const Vector3 start = scaled(lines.edges[2 * i]), edge = scaled(lines.edges[2 * i + 1]) - start;
    const double t = lines.t[i];
    beads.push_back({start, edge, dot(edge, edge), t, std::min(t, kRoom), std::max(t, 1 - kRoom)});
  }
  const std::size_t end_points = lines.closed[l] != 0 ? 0 : 1; // that stay, on either side
  // A step is then a mean of some that each move no two neighbours, and such a one does not make the line longer.
  const double damping = static_cast<double>(count / 2) / static_cast<double>(count);
  std::vector<Vector3> places(count);
  for (Index step = 0; step < steps; ++step) {
    cancel.check();
    std::transform(beads.begin(), beads.end(), places.begin(), [](const Bead& bead) { return bead.place(); });
    for (std::size_t i = end_points; i + end_points < count; ++i) {
      Bead& bead = beads[i];
      if (!(bead.squared > 0)) continue;
      const Vector3 one = places[i == 0 ? count - 1 : i - 1], two = places[i + 1 == count ? 0 : i + 1];
      bead.t += damping * (std::clamp(bead.goal(one, two), bead.least, bead.most) - bead.t);
    }
  }
  for (std::size_t i = 0; i < count; ++i) lines.t[begin + i] = beads[i].t;
}

} // namespace dirichlet
