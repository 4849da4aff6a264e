// SPDX-License-Identifier: GPL-3.0-or-later
#include "renumbering.h"

#include <cmath>

#include "prefetch.h"
#include "workers.h"

namespace dirichlet::ordering {
namespace {

constexpr Index kUnseen = -1, kHub = -2;

/// More than ten times the root of n neighbours are many (Amestoy, Davis & Duff 1996).
Index most_neighbours(std::size_t n) {
  return std::max<Index>(16, static_cast<Index>(10 * std::sqrt(n)));
}

/// Rows follow each other all over memory: asks for those of `vertices` that come soon after the i-th.
void prefetch_rows(const Index* row, const Index* neighbours, std::span<const Index> vertices, std::size_t i) {
  constexpr std::size_t kAhead = 8;
  if (i + 2 * kAhead >= vertices.size()) return;
  prefetch(neighbours + row[vertices[i + kAhead]]);
  prefetch(row + vertices[i + 2 * kAhead]);
}

/// Writes the rows that have their place.
void fill_rows(const Index* row, const Index* neighbours, const Index* number, unsigned threads, Renumbered& result) {
  constexpr std::size_t kRowsAtOnce = 1 << 13;
  const std::size_t count = result.vertices.size();
  result.neighbours.resize(static_cast<std::size_t>(result.offsets.back()));
  share_out(static_cast<Index>((count + kRowsAtOnce - 1) / kRowsAtOnce), threads, [&](Index share, unsigned) {
    const std::size_t first = static_cast<std::size_t>(share) * kRowsAtOnce;
    Index* to = result.neighbours.data() + result.offsets[first];
    for (std::size_t i = first; i < std::min(count, first + kRowsAtOnce); ++i) {
      prefetch_rows(row, neighbours, result.vertices, i);
      const Index v = result.vertices[i];
      for (Index e = row[v]; e < row[v + 1]; ++e)
        if (const Index u = neighbours[e]; u != v && number[u] != kHub) *to++ = number[u];
    }
  });
}

} // namespace

Renumbered renumber(std::span<const Index> offsets, std::span<const Index> neighbours, unsigned threads) {
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

  auto& queue = result.vertices;
  queue.resize(static_cast<std::size_t>(n) + 1); // one for who was met before
  result.offsets.assign(1, 0);
  result.offsets.reserve(queue.size());
  Index met = 0;
  const auto visit = [&](Index v) { // most were met before, but none knows who: no branch
    const Index is_new = static_cast<Index>(number[v] == kUnseen);
    queue[static_cast<std::size_t>(met)] = v;
    number[v] = is_new != 0 ? met : number[v];
    met += is_new;
  };
  for (Index start = 0, head = 0; start < n; ++start)
    for (visit(start); head < met; ++head) {
      const auto i = static_cast<std::size_t>(head);
      prefetch_rows(row, neighbours.data(), std::span(queue.data(), static_cast<std::size_t>(met)), i);
      const Index v = queue[i];
      Index end = result.offsets.back();
      for (Index e = row[v]; e < row[v + 1]; ++e) {
        const Index u = neighbours[static_cast<std::size_t>(e)];
        visit(u);
        end += static_cast<Index>(u != v && number[u] != kHub);
      }
      result.offsets.push_back(end);
    }
  queue.resize(static_cast<std::size_t>(met));
  fill_rows(row, neighbours.data(), number, threads, result);
  return result;
}

} // namespace dirichlet::ordering
