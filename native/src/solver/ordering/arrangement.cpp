// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement.h"

#include <utility>

#include "leaf.h"
#include "lump.h"
#include "workers.h"

namespace dirichlet::ordering {
namespace {

constexpr std::size_t kRegionsAtOnce = 32;

/// Where regions and separators begin in the order.
struct Layout {
  std::vector<Index> region, separator;

  [[nodiscard]] Index& of(Index r) {
    return r < 0 ? separator[static_cast<std::size_t>(RegionTree::division_of(r))]
                 : region[static_cast<std::size_t>(r)];
  }
};

/// Turns sizes into positions for what comes from division k, or from region r if k is none. \returns the next free
/// one.
Index lay_out(const RegionTree& tree, Index k, Index r, Index position, Layout& layout) {
  if (k == kNone) return position + std::exchange(layout.of(r), position);
  position = lay_out(tree, tree[k].left, k, position, layout);
  position = lay_out(tree, tree[k].right, k + 1, position, layout);
  return position + std::exchange(layout.of(RegionTree::separator(k)), position);
}

/// Orders a region that is too large for a leaf.
void order_large(const Graph& graph, std::span<const Index> vertices, const Index* place, Index position,
                 Index* order) {
  const auto size = static_cast<Index>(vertices.size());
  std::vector<Index> offsets{0}, neighbours;
  for (const Index v : vertices) {
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (const Index i = place[graph.neighbours[e]] - position; i >= 0 && i < size) neighbours.push_back(i);
    offsets.push_back(static_cast<Index>(neighbours.size()));
  }
  for (const Index i : order_lump({size, offsets.data(), neighbours.data()}))
    *order++ = vertices[static_cast<std::size_t>(i)];
}

} // namespace

std::vector<Index> arrange(const Graph& graph, const RegionTree& tree, const Regions& regions, unsigned threads) {
  const std::size_t count = regions.count();
  Layout begin{std::vector<Index>(count, 0), std::vector<Index>(static_cast<std::size_t>(tree.size()), 0)};
  for (Index v = 0; v < graph.size; ++v) ++begin.of(regions[v]);
  lay_out(tree, tree.root(), 0, 0, begin);
  Layout end = begin;
  std::vector<Index> order(static_cast<std::size_t>(graph.size)), place(order.size());
  for (Index v = 0; v < graph.size; ++v) {
    Index& next = end.of(regions[v]);
    place[static_cast<std::size_t>(v)] = next;
    order[static_cast<std::size_t>(next++)] = v;
  }
  const auto order_region = [&](std::size_t r) {
    const Index first = begin.region[r], last = end.region[r];
    const std::vector<Index> vertices(order.begin() + first, order.begin() + last);
    (last - first <= kLargestLeaf ? order_leaf : order_large)(graph, vertices, place.data(), first,
                                                              order.data() + first);
  };
  const auto shares = static_cast<Index>((count + kRegionsAtOnce - 1) / kRegionsAtOnce);
  share_out(shares, threads, [&](Index share, unsigned /*worker*/) {
    const auto first = static_cast<std::size_t>(share) * kRegionsAtOnce;
    for (std::size_t r = first; r < std::min(count, first + kRegionsAtOnce); ++r) order_region(r);
  });
  return order;
}

} // namespace dirichlet::ordering
