// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "dirichlet/mesh.h"

namespace dirichlet {

/// The combinatorial half of isolines, without a coordinate. Levels are ranks 0 … K - 1 in ascending order; numbers[v]
/// is how many of them are <= the value of vertex v, so that v is above level k when numbers[v] > k; kUndefined where v
/// has no value.
constexpr Index kUndefined = -1;

/// Which triangles every level crosses: triangles[offsets[k] … offsets[k + 1]), ascending.
struct Crossings {
  std::vector<Index> offsets;
  std::vector<Index> triangles;
};

/// \throws InputError  more than 2^30 crossings. Cost: O(T + K + crossings).
Crossings find_crossings(std::span<const Index> corners, std::span<const Index> numbers, Index level_count);

/// Follows lines from triangle to triangle. Each thread has one of its own, for the marks.
class LineTracer {
 public:
  /// Walks over mesh.triangulated().
  LineTracer(const Mesh& mesh, std::span<const Index> numbers);

  /// Whether a line of `level` has come through here; asked for while no other level has been traced since.
  [[nodiscard]] bool visited(Index triangle, Index level) const { return mark_[at(triangle)] == level; }

  /// Replaces `half_edges` by those that the line through `triangle` crosses, in order, higher values on the left of
  /// that triangle. An open line starts and ends where there is no way on. \returns whether it is closed.
  bool trace(Index triangle, Index level, std::vector<Index>& half_edges);

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  [[nodiscard]] Index number(Index corner) const { return numbers_[at(corners_[at(corner)])]; }
  [[nodiscard]] Index across(Index half_edge) const;
  bool walk(Index half_edge, Index level, std::vector<Index>& half_edges);

  const Mesh& mesh_;
  std::span<const Index> corners_;
  std::span<const Index> opposite_;
  std::span<const Index> numbers_;
  std::vector<Index> mark_; ///< the level traced last through every triangle
};

} // namespace dirichlet
