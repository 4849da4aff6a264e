// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening.h"

#include <numeric>

namespace dirichlet::ordering {
namespace {

constexpr Index kNone = -1;
constexpr Index kLargestStar = 16; // a hub with all its neighbours would be a lump that nothing can divide

template <class G>
bool may_be_centre(const G& graph, const Index* aggregate, Index v) {
  if (aggregate[v] != kNone || graph.offsets[v + 1] - graph.offsets[v] > kLargestStar) return false;
  for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
    if (aggregate[graph.neighbours[e]] != kNone) return false;
  return true;
}

/// Vertices none of whose neighbours is taken become centres and take them all.
template <class G>
Index gather_stars(const G& graph, Index* aggregate) {
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
template <class G>
Index place_leftovers(const G& graph, Index* aggregate, Index count) {
  for (Index v = 0; v < graph.size; ++v) {
    if (aggregate[v] != kNone) continue;
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1] && aggregate[v] == kNone; ++e)
      aggregate[v] = aggregate[graph.neighbours[e]];
    if (aggregate[v] == kNone) aggregate[v] = count++;
  }
  return count;
}

template <class G>
void list_members(const G& fine, CoarseGraph& coarse) {
  Index* offsets = coarse.member_offsets.fit(coarse.size + 1);
  Index* members = coarse.members.fit(fine.size);
  std::fill_n(offsets, coarse.size + 1, 0);
  for (Index v = 0; v < fine.size; ++v) ++offsets[coarse.aggregate[v]];
  std::partial_sum(offsets, offsets + coarse.size, offsets);
  offsets[coarse.size] = fine.size;
  for (Index v = fine.size; v-- > 0;) members[--offsets[coarse.aggregate[v]]] = v;
}

/// The rows of the coarse graph. slot[b] is where the row under way holds b, if not below where that row starts.
template <class G>
void contract(const G& fine, Index* slot, CoarseGraph& coarse) {
  Index* offsets = coarse.offsets.fit(coarse.size + 1);
  Index* neighbours = coarse.neighbours.fit(fine.offsets[fine.size]);
  Index* edge_weights = coarse.edge_weights.fit(fine.offsets[fine.size]);
  Index* weights = coarse.weights.fit(coarse.size);
  const Index* aggregate = coarse.aggregate.data();
  std::fill_n(slot, coarse.size, kNone);
  Index end = 0;
  for (Index a = 0; a < coarse.size; ++a) {
    const Index begin = offsets[a] = end;
    weights[a] = 0;
    for (Index m = coarse.member_offsets[a]; m < coarse.member_offsets[a + 1]; ++m) {
      const Index v = coarse.members[m];
      weights[a] += fine.weight(v);
      for (Index e = fine.offsets[v]; e < fine.offsets[v + 1]; ++e) {
        const Index b = aggregate[fine.neighbours[e]];
        if (b == a) continue;
        if (slot[b] >= begin) {
          edge_weights[slot[b]] += fine.edge_weight(e);
        } else {
          slot[b] = end;
          neighbours[end] = b;
          edge_weights[end++] = fine.edge_weight(e);
        }
      }
    }
  }
  offsets[coarse.size] = end;
}

template <class G>
void coarsen_any(const G& fine, Scratch<Index>& scratch, CoarseGraph& coarse) {
  Index* aggregate = coarse.aggregate.fit(fine.size);
  std::fill_n(aggregate, fine.size, kNone);
  coarse.size = place_leftovers(fine, aggregate, gather_stars(fine, aggregate));
  list_members(fine, coarse);
  contract(fine, scratch.fit(coarse.size), coarse);
}

} // namespace

void coarsen(const Graph& fine, Scratch<Index>& scratch, CoarseGraph& coarse) {
  coarsen_any(fine, scratch, coarse);
}

void coarsen(const CoarseGraph& fine, Scratch<Index>& scratch, CoarseGraph& coarse) {
  coarsen_any(fine, scratch, coarse);
}

} // namespace dirichlet::ordering
