// SPDX-License-Identifier: GPL-3.0-or-later
#include "isoline_tracing.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <mutex>
#include <numeric>

#include "dirichlet/error.h"
#include "message.h"
#include "parallel.h"
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
                std::vector<Index>& active) {
  std::array<Index, 1024> block; // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
  while (begin < end) {
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
std::vector<Index> active_triangles(std::span<const Index> corners, std::span<const Index> numbers) {
  std::map<std::size_t, std::vector<Index>> pieces; // by where they begin
  std::mutex mutex;
  parallel_chunks(corners.size() / 3, std::size_t{1} << 16, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> active;
    add_active(corners, numbers, begin, end, active);
    const std::scoped_lock lock(mutex);
    pieces.emplace(begin, std::move(active));
  });
  std::vector<Index> all = std::move(pieces.begin()->second);
  for (auto piece = std::next(pieces.begin()); piece != pieces.end(); ++piece)
    all.insert(all.end(), piece->second.begin(), piece->second.end());
  return all;
}

} // namespace

Crossings find_crossings(std::span<const Index> corners, std::span<const Index> numbers, Index level_count) {
  constexpr std::int64_t kMost = std::int64_t{1} << 30; // points are counted in 32 bits, at most two to a crossing
  const std::vector<Index> active = active_triangles(corners, numbers);
  std::int64_t total = 0;
  std::vector<Index> next(static_cast<std::size_t>(level_count) + 1, 0); // first by how much the crossings of a level
  for (const Index f : active) {                                         // exceed those of the level below
    const auto [low, high] = level_range(corners, numbers, static_cast<std::size_t>(f));
    ++next[static_cast<std::size_t>(low)];
    --next[static_cast<std::size_t>(high)];
    total += high - low;
  }
  if (total > kMost)
    throw InputError(
        message("the levels cross the triangles ", total, " times, more than the ", kMost, " there can be"));

  std::partial_sum(next.begin(), next.end(), next.begin());
  std::exclusive_scan(next.begin(), next.end(), next.begin(), Index{0});
  Crossings crossings{next, std::vector<Index>(static_cast<std::size_t>(total))};
  for (const Index f : active) {
    const auto [low, high] = level_range(corners, numbers, static_cast<std::size_t>(f));
    for (auto k = static_cast<std::size_t>(low); k < static_cast<std::size_t>(high); ++k)
      crossings.triangles[static_cast<std::size_t>(next[k]++)] = f;
  }
  return crossings;
}

LineTracer::LineTracer(const Mesh& mesh, std::span<const Index> numbers)
    : mesh_(mesh), corners_(mesh.triangulated().corners()), opposite_(mesh.triangulated().connectivity().opposite),
      numbers_(numbers), mark_(corners_.size() / 3, -1) {}

bool LineTracer::trace(Index triangle, Index level, std::vector<Index>& half_edges) {
  half_edges.clear();
  mark_[at(triangle)] = level;
  Index entry = 3 * triangle; // from above to below: what is above lies on the left of a line that comes in here
  while (number(entry) <= level || number(next(entry)) > level) ++entry;
  const bool closed = walk(entry, level, half_edges);
  std::reverse(half_edges.begin(), half_edges.end());
  if (closed) return true; // through the exit, on the other side of which that walk ended
  Index exit = 3 * triangle;
  while (number(exit) > level || number(next(exit)) <= level) ++exit;
  walk(exit, level, half_edges);
  return false;
}

Index LineTracer::across(Index half_edge) const {
  const Index other = opposite_[at(half_edge)];
  const bool ambiguous = other == Connectivity::kNonManifold && !mesh_.is_triangular();
  return ambiguous ? opposite_in_polygons(mesh_, half_edge) : other;
}

/// Leaves a triangle through `half_edge` and goes on. What counts is which edges are crossed, not which way half-edges
/// point, so a turned-over neighbour is no obstacle. \returns whether the line came back to where it began.
bool LineTracer::walk(Index half_edge, Index level, std::vector<Index>& half_edges) {
  while (true) {
    half_edges.push_back(half_edge);
    const Index other = across(half_edge);
    if (other < 0) return false;
    const Index triangle = other / 3;
    if (visited(triangle, level)) return true;
    const Index head = next(other), apex = next(head);
    if (number(apex) == kUndefined) return false;
    mark_[at(triangle)] = level;
    half_edge = (number(apex) > level) != (number(head) > level) ? head : apex;
  }
}

} // namespace dirichlet
