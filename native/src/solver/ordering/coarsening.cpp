// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening.h"

#include <numeric>

namespace dirichlet::ordering {
namespace {

constexpr Index kLargestStar = 16; // a hub with all its neighbours would be a lump that nothing can divide

bool may_be_centre(const Graph& graph, const Index* aggregate, Index v) {
  if (aggregate[v] != kNone || graph.offsets[v + 1] - graph.offsets[v] > kLargestStar) return false;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    if (aggregate[graph.neighbours[e]] != kNone) return false;
  return true;
}

/// Vertices none of whose neighbours is taken become centres and take them all.
Index gather_stars(const Graph& graph, Index* aggregate) {
  Index count = 0;
  for (Index v = 0; v < graph.size; ++v) {
    if (!may_be_centre(graph, aggregate, v)) continue;
    aggregate[v] = count;
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) aggregate[graph.neighbours[e]] = count;
    ++count;
  }
  return count;
}

/// What stars left over joins the first neighbour that has found its place, or stays alone.
Index place_leftovers(const Graph& graph, Index* aggregate, Index count) {
  for (Index v = 0; v < graph.size; ++v) {
    if (aggregate[v] != kNone) continue;
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1] && aggregate[v] == kNone; ++e)
      aggregate[v] = aggregate[graph.neighbours[e]];
    if (aggregate[v] == kNone) aggregate[v] = count++;
  }
  return count;
}

/// A step through 0 … size - 1 that comes by every number: 1 for variant 0, else about a golden section.
Index stride(Index size, Index variant) {
  Index step = (variant == 0 ? 1 : static_cast<Index>(size * 0.381966) + 7 * variant) % size;
  while (std::gcd(step, size) != 1) ++step;
  return step;
}

/// Pairs every vertex with the free neighbour it shares the heaviest edge with.
Index match(const WeightedGraph& graph, Index variant, Index* aggregate) {
  const Index step = stride(graph.size, variant);
  Index count = 0, v = 0;
  for (Index k = 0; k < graph.size; ++k, v += v < graph.size - step ? step : step - graph.size) {
    if (aggregate[v] != kNone) continue;
    Index mate = v, weight = 0;
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (const Index u = graph.neighbours[e]; aggregate[u] == kNone && graph.edge_weight(e) > weight) {
        weight = graph.edge_weight(e);
        mate = u;
      }
    aggregate[v] = aggregate[mate] = count++;
  }
  return count;
}

template <class G>
void list_members(const G& fine, const CoarseGraph& coarse, CoarseningScratch& scratch) {
  Index* offsets = scratch.member_offsets.fit(coarse.size + 1);
  Index* members = scratch.members.fit(fine.size);
  std::fill_n(offsets, coarse.size + 1, 0);
  for (Index v = 0; v < fine.size; ++v) ++offsets[coarse.aggregate[v]];
  std::partial_sum(offsets, offsets + coarse.size, offsets);
  offsets[coarse.size] = fine.size;
  for (Index v = fine.size; v-- > 0;) members[--offsets[coarse.aggregate[v]]] = v;
}

/// The rows of the coarse graph. slot[b] is where the row under way holds b, if not below where that row starts. The
/// loop over edges is the most expensive of all dissection and has no branch that could be mispredicted: edges inside
/// the aggregate are written, too, to a place beyond all rows.
template <class G>
void contract(const G& fine, CoarseningScratch& scratch, CoarseGraph& coarse) {
  list_members(fine, coarse, scratch);
  Index* slot = scratch.slot.fit(coarse.size);
  const Index beyond = fine.offsets[fine.size];
  Index* offsets = coarse.offsets.fit(coarse.size + 1);
  Index* neighbours = coarse.neighbours.fit(beyond + 1);
  Index* edge_weights = coarse.edge_weights.fit(beyond + 1);
  Index* weights = coarse.weights.fit(coarse.size);
  const Index* aggregate = coarse.aggregate.data();
  std::fill_n(slot, coarse.size, kNone);
  edge_weights[beyond] = 0;
  Index end = 0;
  for (Index a = 0; a < coarse.size; ++a) {
    const Index begin = offsets[a] = end;
    weights[a] = 0;
    slot[a] = beyond;
    for (Index m = scratch.member_offsets[a]; m < scratch.member_offsets[a + 1]; ++m) {
      const Index v = scratch.members[m];
      weights[a] += fine.weight(v);
      for (Index e = fine.offsets[v]; e < fine.offsets[v + 1]; ++e) {
        const Index b = aggregate[fine.neighbours[e]];
        const bool met = slot[b] >= begin;
        const Index place = met ? slot[b] : end;
        edge_weights[place] = (met ? edge_weights[place] : 0) + fine.edge_weight(e);
        neighbours[place] = b;
        slot[b] = place;
        end += static_cast<Index>(!met);
      }
    }
    slot[a] = kNone;
  }
  offsets[coarse.size] = end;
}

} // namespace

void coarsen(const Graph& fine, CoarseningScratch& scratch, CoarseGraph& coarse) {
  Index* aggregate = coarse.aggregate.fit(fine.size);
  std::fill_n(aggregate, fine.size, kNone);
  coarse.size = place_leftovers(fine, aggregate, gather_stars(fine, aggregate));
  contract(fine, scratch, coarse);
}

void coarsen(const WeightedGraph& fine, Index variant, CoarseningScratch& scratch, CoarseGraph& coarse) {
  Index* aggregate = coarse.aggregate.fit(fine.size);
  std::fill_n(aggregate, fine.size, kNone);
  coarse.size = match(fine, variant, aggregate);
  contract(fine, scratch, coarse);
}

} // namespace dirichlet::ordering
