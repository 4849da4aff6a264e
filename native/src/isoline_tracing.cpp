// SPDX-License-Identifier: GPL-3.0-or-later
#include "isoline_tracing.h"

#include <algorithm>
#include <array>

#include "dirichlet/error.h"
#include "index.h"
#include "memory.h"
#include "message.h"
#include "parallel_collect.h"
#include "polygon_opposite.h"

namespace dirichlet {
namespace {

/// Levels low … high - 1 cross a triangle.
struct Range {
  Index low, high;
};

Range level_range(std::span<const Index> corners, std::span<const Index> numbers, std::size_t triangle) {
  const auto number = [&](std::size_t i) { return numbers[static_cast<std::size_t>(corners[3 * triangle + i])]; };
  const Index a = number(0), b = number(1), c = number(2);
  return {std::min(a, std::min(b, c)), std::max(a, std::max(b, c))};
}

/// Adds the triangles of [begin, end) that any level crosses. Without a branch, which one triangle in ten would
/// mispredict: each is written down, and the next overwrites those that do not count.
void add_active(std::span<const Index> corners, std::span<const Index> numbers, std::size_t begin, std::size_t end,
                const CancelToken& cancel, Buffer<Index>& active) {
  std::array<Index, 1024> block; // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  while (begin < end) {
    cancel.check();
    const std::size_t stop = std::min(end, begin + block.size());
    std::size_t count = 0;
    for (; begin < stop; ++begin) {
      const auto [low, high] = level_range(corners, numbers, begin);
      block[count] = static_cast<Index>(begin);
      count += static_cast<std::size_t>(static_cast<int>(low != high) & static_cast<int>(low != kUndefined));
    }
    active.insert(active.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

/// The triangles that any level crosses, ascending.
Buffer<Index> active_triangles(std::span<const Index> corners, std::span<const Index> numbers,
                               const CancelToken& cancel) {
  constexpr std::size_t kGrain = 1 << 16;
  return parallel_collect<Index>(corners.size() / 3, kGrain, [&](std::size_t begin, std::size_t end, auto& active) {
    add_active(corners, numbers, begin, end, cancel, active);
  });
}

/// A level that crosses a triangle does so from one half-edge, which goes down (from above the level to below), to
/// another, which goes up. These are the *ends* of the crossing c: 2c and 2c + 1.
struct Crossings {
  Buffer<Index> active;    ///< the triangles that any level crosses, ascending
  Buffer<Index> base;      ///< (T,) level k crosses triangle f as number base[f] + k; of active ones only
  Buffer<Index> level;     ///< (X,)
  Buffer<Index> half_edge; ///< (2X,) of every end
  Buffer<Index> across;    ///< (2X,) the end on the other side of that half-edge, or -1
};

/// Crossings are numbered by triangle, then by level.
Crossings number_crossings(std::span<const Index> corners, std::span<const Index> numbers, const CancelToken& cancel) {
  constexpr std::int64_t kMost = (std::int64_t{1} << 30) - 1; // two ends each, or points, are counted in 32 bits
  Crossings crossings;
  crossings.active = active_triangles(corners, numbers, cancel);
  crossings.base.resize(corners.size() / 3);
  std::int64_t total = 0;
  for (const Index f : crossings.active) {
    const auto [low, high] = level_range(corners, numbers, at(f));
    crossings.base[at(f)] = static_cast<Index>(total - low);
    total += high - low;
  }
  if (total > kMost)
    throw InputError(
        message("the levels cross the triangles ", total, " times, more than the ", kMost, " there can be"));
  constexpr std::int64_t kBytes = 80; // a crossing here, and the point that it becomes
  if (total > physical_memory() / kBytes)
    throw InputError(message("the levels cross the triangles ", total, " times, which takes ", in_bytes(total * kBytes),
                             ", more memory than there is; fewer levels take less"));
  const auto count = static_cast<std::size_t>(total);
  crossings.level.resize(count);
  crossings.half_edge.resize(2 * count);
  crossings.across.resize(2 * count);
  return crossings;
}

/// Finds out how crossings go on in the triangle's neighbours.
class CrossingLinker {
 public:
  CrossingLinker(const Mesh& mesh, std::span<const Index> numbers, Crossings& crossings)
      : mesh_(mesh), corners_(mesh.triangulated().corners()), opposite_(mesh.triangulated().connectivity().opposite),
        numbers_(numbers), crossings_(crossings) {}

  /// Without a branch on how a level crosses, which would be mispredicted.
  void link(Index triangle) {
    const auto [low, high] = level_range(corners_, numbers_, at(triangle));
    const Index a = number(3 * triangle), b = number(3 * triangle + 1), c = number(3 * triangle + 2);
    for (Index level = low; level < high; ++level) {
      const auto above = static_cast<std::size_t>(a > level) + 2 * static_cast<std::size_t>(b > level) +
                         4 * static_cast<std::size_t>(c > level);
      const Index crossing = crossings_.base[at(triangle)] + level;
      crossings_.level[at(crossing)] = level;
      for (Index up = 0; up < 2; ++up) {
        const Index half_edge = 3 * triangle + kSide[at(up)][above];
        crossings_.half_edge[at(2 * crossing + up)] = half_edge;
        crossings_.across[at(2 * crossing + up)] = across(half_edge, up, level);
      }
    }
  }

 private:
  /// The side that goes down, or up, by which corners are above the level.
  static constexpr std::array<std::array<Index, 8>, 2> kSide{{{0, 0, 1, 1, 2, 0, 2, 0}, {0, 2, 0, 2, 1, 1, 0, 0}}};

  /// The end on the other side of `half_edge`, which goes up or down. That of a turned-over neighbour, whose half-edge
  /// starts at the same vertex, goes the same way.
  [[nodiscard]] Index across(Index half_edge, Index up, Index level) const {
    const Index other = opposite(half_edge);
    if (other < 0 || number(next_in_triangle(next_in_triangle(other))) == kUndefined) return -1;
    const bool turned = corners_[at(other)] == corners_[at(half_edge)];
    return 2 * (crossings_.base[at(other / 3)] + level) + (turned ? up : 1 - up);
  }

  [[nodiscard]] Index number(Index corner) const { return numbers_[at(corners_[at(corner)])]; }
  [[nodiscard]] Index opposite(Index half_edge) const {
    const Index other = opposite_[at(half_edge)];
    const bool ambiguous = other == Connectivity::kNonManifold && !mesh_.is_triangular();
    return ambiguous ? opposite_in_polygons(mesh_, half_edge) : other;
  }

  const Mesh& mesh_;
  std::span<const Index> corners_;
  std::span<const Index> opposite_;
  std::span<const Index> numbers_;
  Crossings& crossings_;
};

/// Joins crossings to lines.
class LineTracer {
 public:
  LineTracer(const Crossings& crossings, const CancelToken& cancel)
      : crossings_(crossings), cancel_(cancel), visited_(crossings.level.size(), 0) {
    traces_.half_edges.reserve(crossings.level.size());
  }

  Traces trace() {
    for (std::size_t c = 0; c < visited_.size(); ++c)
      if (visited_[c] == 0) trace_line(static_cast<Index>(c));
    return std::move(traces_);
  }

 private:
  /// First back through the half-edge that goes down: what is above lies on the left of a line that comes in there.
  void trace_line(Index crossing) {
    const auto begin = static_cast<std::ptrdiff_t>(traces_.half_edges.size());
    visited_[at(crossing)] = 1;
    const bool closed = walk(2 * crossing);
    std::reverse(traces_.half_edges.begin() + begin, traces_.half_edges.end());
    if (!closed) walk(2 * crossing + 1);
    traces_.offsets.push_back(static_cast<Index>(traces_.half_edges.size()));
    traces_.closed.push_back(closed ? 1 : 0);
    traces_.level.push_back(crossings_.level[at(crossing)]);
  }

  /// Leaves a triangle by `end` and goes on. \returns whether the line came back to where it began.
  bool walk(Index end) {
    constexpr std::size_t kSteps = 1 << 16; // between looks at the token
    while (true) {
      if (traces_.half_edges.size() % kSteps == 0) cancel_.check();
      traces_.half_edges.push_back(crossings_.half_edge[at(end)]);
      const Index entered = crossings_.across[at(end)];
      if (entered < 0) return false;
      if (visited_[at(entered / 2)] != 0) return true;
      visited_[at(entered / 2)] = 1;
      end = entered ^ 1; // the other end of the same crossing
    }
  }

  const Crossings& crossings_;
  const CancelToken& cancel_;
  std::vector<std::uint8_t> visited_;
  Traces traces_;
};

} // namespace

Traces trace_lines(const Mesh& mesh, std::span<const Index> numbers, const CancelToken& cancel) {
  Crossings crossings = number_crossings(mesh.triangulated().corners(), numbers, cancel);
  CrossingLinker linker(mesh, numbers, crossings);
  constexpr std::size_t kGrain = 1 << 12; // triangles that a thread is worth
  parallel_chunks(crossings.active.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i % kGrain == 0) cancel.check();
      linker.link(crossings.active[i]);
    }
  });
  return LineTracer(crossings, cancel).trace();
}

} // namespace dirichlet
