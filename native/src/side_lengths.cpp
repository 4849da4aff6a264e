// SPDX-License-Identifier: GPL-3.0-or-later
#include "side_lengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <queue>
#include <utility>

#include "flat_faces.h"
#include "groups.h"
#include "index.h"
#include "parallel_collect.h"
#include "vector3.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 13;

/// How much shorter than the other two together a side has to be, relative to the longest: what is far above the
/// rounding of lengths.
constexpr double kSlack = 2e-13;
/// The least a side has to have of the longest.
constexpr double kShortest = 1e-13;

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
  parallel_chunks(corners.size(), kGrain, [&, first = low](std::size_t begin, std::size_t end) {
    std::array<double, 3> lowest{first}, highest{first};
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

/// What vertices add to all sides that end at them. No triangle inequality suffers from it, and the one at its own
/// corner gains twice as much: hence only vertices of bad triangles add something.
class Mollifier {
 public:
  Mollifier(const Mesh& triangles, Buffer<double>& sides, const Buffer<Index>& bad_faces)
      : corners_(triangles.corners()), around_(triangles.corners_by_vertex()), sides_(sides),
        more_(at(triangles.vertex_count()), 0.0) {
    for (const Index face : bad_faces) ask_for(3 * face);
    spread();
    for (const Index face : bad_faces) // a piece that is one point: of any size
      for (Index c = 3 * face; c < 3 * face + 3; ++c)
        if (sides_[at(c)] == 0 && more(c) == 0) more(c) = 1;
  }

  /// \returns (V,) 1 where sides got longer
  Buffer<std::uint8_t> lengthen() {
    parallel_chunks(corners_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (auto c = static_cast<Index>(begin); c < static_cast<Index>(end); ++c)
        sides_[at(c)] += more(c) + more(next_in_triangle(c));
    });
    Buffer<std::uint8_t> lengthened(more_.size());
    std::transform(more_.begin(), more_.end(), lengthened.begin(), [](double more) { return more > 0 ? 1 : 0; });
    return lengthened;
  }

 private:
  [[nodiscard]] double& more(Index corner) { return more_[at(corners_[at(corner)])]; }

  void raise(Index corner, double least) { more(corner) = std::max(more(corner), least); }

  void ask_for(Index first) {
    const std::array<Index, 3> corner{first, first + 1, first + 2};
    double longest = std::max({sides_[at(corner[0])], sides_[at(corner[1])], sides_[at(corner[2])]});
    if (longest == 0) // a point: as small beside its neighbours
      for (const Index c : corner) longest = std::max(longest, longest_side_at(corners_[at(c)]));
    for (std::size_t k = 0; k < 3; ++k) {
      const Index c = corner[k], after = corner[(k + 1) % 3], before = corner[(k + 2) % 3];
      const double slack = sides_[at(c)] + sides_[at(before)] - sides_[at(after)];
      raise(c, (kSlack * longest - slack) / 2);
      for (const Index end : {c, after}) raise(end, (kShortest * longest - sides_[at(c)]) / 2);
    }
  }

  [[nodiscard]] double longest_side_at(Index vertex) const {
    double longest = 0;
    for (const Index c : around_[vertex])
      longest = std::max({longest, sides_[at(c)], sides_[at(next_in_triangle(next_in_triangle(c)))]});
    return longest;
  }

  /// What one vertex adds, others that are nearer than that add as well, but for the distance: triangles between them
  /// would be needles again.
  void spread() {
    using Reached = std::pair<double, Index>;
    std::priority_queue<Reached> queue;
    for (Index v = 0; v < static_cast<Index>(more_.size()); ++v)
      if (more_[at(v)] > 0) queue.emplace(more_[at(v)], v);
    while (!queue.empty()) {
      const auto [most, v] = queue.top();
      queue.pop();
      if (most < more_[at(v)]) continue;
      for (const Index c : around_[v]) {
        const Index next = next_in_triangle(c), before = next_in_triangle(next);
        for (const auto& [neighbour, side] : {std::pair{next, c}, {before, before}})
          if (const double least = most - sides_[at(side)]; least > more(neighbour)) {
            more(neighbour) = least;
            queue.emplace(least, corners_[at(neighbour)]);
          }
      }
    }
  }

  std::span<const Index> corners_;
  const Groups& around_;
  Buffer<double>& sides_;
  Buffer<double> more_; ///< (V,)
};

bool is_bad(double a, double b, double c) {
  const double longest = std::max({a, b, c}), shortest = std::min({a, b, c});
  const double slack = (a + b + c - longest) - longest;
  return !(slack >= kSlack * longest && shortest >= kShortest * longest && longest > 0);
}

} // namespace

SideLengths mollified_sides(const Mesh& triangles) {
  const std::span<const Index> corners = triangles.corners();
  const double* const p = triangles.positions().data();
  const double scale = unit_scale(extent(triangles));
  SideLengths result;
  Buffer<double>& sides = result.lengths;
  sides.resize(corners.size());
  const auto bad_faces =
      parallel_collect<Index>(at(triangles.face_count()), kGrain, [&](std::size_t begin, std::size_t end, auto& bad) {
        for (std::size_t face = begin; face < end; ++face) {
          const Index* const corner = &corners[3 * face];
          double* const side = &sides[3 * face];
          for (std::size_t k = 0; k < 3; ++k)
            side[k] = distance(p + 3 * at(corner[k]), p + 3 * at(corner[(k + 1) % 3]), scale);
          if (is_bad(side[0], side[1], side[2])) bad.push_back(static_cast<Index>(face));
        }
      });
  result.thickened = static_cast<Index>(std::count_if(bad_faces.begin(), bad_faces.end(), [&](Index face) {
    return !is_flat(triangles.positions(), corners.subspan(3 * at(face), 3));
  }));
  if (!bad_faces.empty()) result.lengthened = Mollifier(triangles, sides, bad_faces).lengthen();
  return result;
}

} // namespace dirichlet
