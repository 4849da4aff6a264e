// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_splitter.h"

#include <limits>
#include <numeric>

#include "workers.h"

namespace dirichlet::ordering {
namespace {

constexpr std::uint8_t kDeepest = 200; // far below what even divisions need; only lumps come so deep
constexpr Index kSmallestShare = 1000; // vertices worth a thread

/// How many divisions lie above a region.
std::uint8_t depth_of(std::size_t region, const Regions& regions) {
  const std::uint8_t left = region > 0 ? regions.depth[region - 1] : std::uint8_t{0};
  return region < regions.depth.size() ? std::max(left, regions.depth[region]) : left;
}

} // namespace

/// Round by round, as the halves of a round are the next round's regions.
template <class G>
void RegionSplitter::split(const G& graph, Index weight, Index vertices, Regions& regions) {
  number_.fit(graph.size);
  half_.fit(graph.size);
  is_new_.assign(regions.count(), 1);
  while (true) {
    count(graph, regions);
    choose_large(weight, vertices, regions);
    halve_large(graph, regions);
    if (std::all_of(parts_.begin(), parts_.end(), [](std::uint8_t parts) { return parts == 1; })) return;
    renumber(graph.size, regions);
  }
}

template <class G>
void RegionSplitter::count(const G& graph, Regions& regions) {
  size_.assign(regions.count(), 0);
  regions.weight.assign(regions.count(), 0);
  for (Index v = 0; v < graph.size; ++v) {
    const auto r = static_cast<std::size_t>(regions[v]);
    ++size_[r];
    regions.weight[r] += graph.weight(v);
  }
}

/// Also sets parts_ to what becomes of the other regions.
void RegionSplitter::choose_large(Index weight, Index vertices, const Regions& regions) {
  parts_.assign(regions.count(), 1);
  begin_.assign(regions.count(), kNone);
  large_.clear();
  Index listed = 0;
  for (std::size_t r = 0; r < regions.count(); ++r) {
    if (size_[r] == 0) parts_[r] = 0;
    if (is_new_[r] == 0 || size_[r] <= vertices || regions.weight[r] <= weight || depth_of(r, regions) >= kDeepest)
      continue;
    large_.push_back(static_cast<Index>(r));
    begin_[r] = listed;
    listed += size_[r];
  }
  vertices_.resize(static_cast<std::size_t>(listed));
}

template <class G>
void RegionSplitter::halve_large(const G& graph, const Regions& regions) {
  if (large_.empty()) return;
  std::vector<Index> end = begin_;
  for (Index v = 0; v < graph.size; ++v)
    if (Index& next = end[static_cast<std::size_t>(regions[v])]; next != kNone)
      vertices_[static_cast<std::size_t>(next++)] = v;
  const auto threads = vertices_.size() < kSmallestShare ? 1U : static_cast<unsigned>(tools_.size());
  share_out(static_cast<Index>(large_.size()), threads, [&](Index k, unsigned worker) {
    const auto r = static_cast<std::size_t>(large_[static_cast<std::size_t>(k)]);
    const std::span own(vertices_.data() + begin_[r], static_cast<std::size_t>(size_[r]));
    Tools& tools = tools_[worker];
    const Regions& halves = tools.bisection.halve(extract(graph, regions, own, tools));
    if (halves.weight[0] == 0 || halves.weight[1] == 0) return;
    parts_[r] = 2;
    for (std::size_t i = 0; i < own.size(); ++i)
      half_[own[i]] = static_cast<std::uint8_t>(halves[static_cast<Index>(i)]);
  });
}

/// A region as a graph of its own.
template <class G>
WeightedGraph RegionSplitter::extract(const G& graph, const Regions& regions, std::span<const Index> vertices,
                                      Tools& tools) {
  const auto size = static_cast<Index>(vertices.size());
  const Index region = regions[vertices[0]];
  Index end = 0;
  for (Index i = 0; i < size; ++i) {
    const Index v = vertices[static_cast<std::size_t>(i)];
    number_[v] = i;
    end += graph.offsets[v + 1] - graph.offsets[v];
  }
  const WeightedGraph result{size, tools.offsets.fit(size + 1), tools.neighbours.fit(end), tools.weights.fit(size),
                             tools.edge_weights.fit(end)};
  end = 0;
  for (Index i = 0; i < size; ++i) {
    const Index v = vertices[static_cast<std::size_t>(i)];
    tools.offsets[i] = end;
    tools.weights[i] = graph.weight(v);
    for (Index e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e)
      if (const Index u = graph.neighbours[e]; regions[u] == region) {
        tools.neighbours[end] = number_[u];
        tools.edge_weights[end++] = graph.edge_weight(e);
      }
  }
  tools.offsets[size] = end;
  return result;
}

/// Carries out what parts_ says. With an empty region goes the division just above it, the deeper of the two beside it.
void RegionSplitter::renumber(Index vertex_count, Regions& regions) {
  std::vector<Index> first(regions.count());
  std::vector<std::uint8_t> depth;
  is_new_.clear();
  std::uint8_t before = std::numeric_limits<std::uint8_t>::max();
  for (std::size_t r = 0; r < regions.count(); ++r) {
    if (r > 0) before = std::min(before, regions.depth[r - 1]);
    if (parts_[r] == 0) continue;
    if (!is_new_.empty()) depth.push_back(before);
    before = std::numeric_limits<std::uint8_t>::max();
    first[r] = static_cast<Index>(is_new_.size());
    if (parts_[r] == 2) depth.push_back(static_cast<std::uint8_t>(depth_of(r, regions) + 1));
    is_new_.insert(is_new_.end(), parts_[r], parts_[r] == 2);
  }
  for (Index v = 0; v < vertex_count; ++v) {
    const auto r = static_cast<std::size_t>(regions[v]);
    regions.set(v, first[r] + (parts_[r] == 2 ? half_[v] : 0));
  }
  regions.depth = std::move(depth);
  regions.weight.resize(is_new_.size());
}

template void RegionSplitter::split(const Graph&, Index, Index, Regions&);
template void RegionSplitter::split(const WeightedGraph&, Index, Index, Regions&);

} // namespace dirichlet::ordering
