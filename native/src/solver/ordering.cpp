// SPDX-License-Identifier: GPL-3.0-or-later
#include "ordering.h"

#include "ordering/dissection.h"
#include "ordering/lump.h"
#include "ordering/renumbering.h"

namespace dirichlet {

std::vector<Index> fill_reducing_order(std::span<const Index> offsets, std::span<const Index> neighbours,
                                       unsigned threads, const CancelToken& cancel) {
  const ordering::Renumbered renumbered = ordering::renumber(offsets, neighbours, threads);
  std::vector<Index> order = ordering::dissect(renumbered.graph(), threads, cancel);
  for (Index& v : order) v = renumbered.vertices[static_cast<std::size_t>(v)];
  order.insert(order.end(), renumbered.hubs.begin(), renumbered.hubs.end());
  return order;
}

std::vector<Index> minimum_degree_order(std::span<const Index> offsets, std::span<const Index> neighbours) {
  return ordering::order_lump({static_cast<Index>(offsets.size()) - 1, offsets.data(), neighbours.data()});
}

} // namespace dirichlet
