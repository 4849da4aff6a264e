// SPDX-License-Identifier: GPL-3.0-or-later
#include "renumbering.h"

#include <cmath>

namespace dirichlet::ordering {
namespace {

constexpr Index kUnseen = -1, kHub = -2;

/// More than ten times the root of n neighbours are many (Amestoy, Davis & Duff 1996).
Index most_neighbours(std::size_t n) {
  return std::max<Index>(16, static_cast<Index>(10 * std::sqrt(n)));
}

} // namespace

Renumbered renumber(std::span<const Index> offsets, std::span<const Index> neighbours) {
  const auto n = static_cast<Index>(offsets.empty() ? 0 : offsets.size() - 1);
  const Index* row = offsets.data();
  const Index most = most_neighbours(static_cast<std::size_t>(n));
  Renumbered result;
  std::vector<Index> numbers(static_cast<std::size_t>(n), kUnseen);
  Index* number = numbers.data();
  for (Index v = 0; v < n; ++v)
    if (row[v + 1] - row[v] > most) {
      number[v] = kHub;
      result.hubs.push_back(v);
    }

  std::vector<Index>& queue = result.vertices;
  queue.reserve(static_cast<std::size_t>(n));
  const auto visit = [&](Index v) {
    if (number[v] != kUnseen) return;
    number[v] = static_cast<Index>(queue.size());
    queue.push_back(v);
  };
  for (Index start = 0; start < n; ++start) {
    std::size_t head = queue.size();
    for (visit(start); head < queue.size(); ++head)
      for (Index e = row[queue[head]]; e < row[queue[head] + 1]; ++e) visit(neighbours[static_cast<std::size_t>(e)]);
  }

  result.offsets.reserve(queue.size() + 1);
  result.offsets.push_back(0);
  result.neighbours.reserve(neighbours.size());
  for (const Index v : queue) {
    for (Index e = row[v]; e < row[v + 1]; ++e)
      if (const Index u = neighbours[static_cast<std::size_t>(e)]; u != v && number[u] != kHub)
        result.neighbours.push_back(number[u]);
    result.offsets.push_back(static_cast<Index>(result.neighbours.size()));
  }
  return result;
}

} // namespace dirichlet::ordering
