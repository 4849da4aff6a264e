// SPDX-License-Identifier: GPL-3.0-or-later
#include "ordering.h"

#include "ordering/dissection.h"
#include "ordering/lump.h"
#include "ordering/renumbering.h"

namespace dirichlet {
namespace {

/// The order that the graph gets without its hubs, which come last, as its vertices were numbered at first.
std::vector<Index> with_hubs(std::vector<Index> order, const ordering::Renumbered& renumbered) {
  for (Index& v : order) v = renumbered.vertices[static_cast<std::size_t>(v)];
  order.insert(order.end(), renumbered.hubs.begin(), renumbered.hubs.end());
  return order;
}

} // namespace

std::vector<Index> fill_reducing_order(std::span<const Index> offsets, std::span<const Index> neighbours,
                                       unsigned threads) {
  const ordering::Renumbered renumbered = ordering::renumber(offsets, neighbours, threads);
  return with_hubs(ordering::dissect(renumbered.graph(), threads), renumbered);
}

std::vector<Index> minimum_degree_order(std::span<const Index> offsets, std::span<const Index> neighbours) {
  const ordering::Renumbered renumbered = ordering::renumber(offsets, neighbours, 1);
  return with_hubs(ordering::order_lump(renumbered.graph()), renumbered);
}

} // namespace dirichlet
