// SPDX-License-Identifier: GPL-3.0-or-later
#include "connectivity.h"

#include <algorithm>
#include <numeric>

#include "parallel.h"

namespace dirichlet {
namespace {

struct HalfEdge {
  Index to;     ///< the larger vertex
  Index corner; ///< where it starts
};

/// Calls visit(corner, from, to) for every half-edge, in ascending order of corners.
template <class Visit>
void for_each_half_edge(std::span<const Index> offsets, std::span<const Index> corners, Visit visit) {
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    const Index begin = offsets[f], end = offsets[f + 1];
    for (Index c = begin; c + 1 < end; ++c)
      visit(c, corners[static_cast<std::size_t>(c)], corners[static_cast<std::size_t>(c) + 1]);
    visit(end - 1, corners[static_cast<std::size_t>(end) - 1], corners[static_cast<std::size_t>(begin)]);
  }
}

/// Stable; most vertices have a handful of edges, the hub of a fan may have a million.
void sort_by_target(std::span<HalfEdge> bucket) {
  constexpr std::size_t kInsertion = 24;
  const auto before = [](const HalfEdge& a, const HalfEdge& b) {
    return a.to != b.to ? a.to < b.to : a.corner < b.corner;
  };
  if (bucket.size() > kInsertion) {
    std::sort(bucket.begin(), bucket.end(), before);
    return;
  }
  for (std::size_t i = 1; i < bucket.size(); ++i) {
    const HalfEdge moved = bucket[i];
    std::size_t j = i;
    for (; j > 0 && bucket[j - 1].to > moved.to; --j) bucket[j] = bucket[j - 1];
    bucket[j] = moved;
  }
}

/// The half-edges that share edge `edge`, at `first` … `last` of the sorted ones, learn of it and of each other.
void link(std::span<const HalfEdge> sorted, std::size_t first, std::size_t last, Index edge, Connectivity& out) {
  for (std::size_t i = first; i < last; ++i) {
    const auto corner = static_cast<std::size_t>(sorted[i].corner);
    out.edge_corners[i] = sorted[i].corner;
    out.corner_edges[corner] = edge;
    const std::size_t count = last - first;
    out.opposite[corner] = count == 1   ? Connectivity::kBorder
                           : count == 2 ? sorted[first + last - 1 - i].corner
                                        : Connectivity::kNonManifold;
  }
}

} // namespace

Connectivity build_connectivity(Index vertex_count, std::span<const Index> offsets, std::span<const Index> corners) {
  const auto n = static_cast<std::size_t>(vertex_count);
  std::vector<Index> bucket(n + 1, 0); // where the half-edges of a smaller vertex start
  for_each_half_edge(offsets, corners,
                     [&](Index, Index a, Index b) { ++bucket[static_cast<std::size_t>(std::min(a, b)) + 1]; });
  std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());

  std::vector<HalfEdge> sorted(corners.size());
  std::vector<Index> next(bucket.begin(), bucket.end() - 1);
  for_each_half_edge(offsets, corners, [&](Index c, Index a, Index b) {
    sorted[static_cast<std::size_t>(next[static_cast<std::size_t>(std::min(a, b))]++)] = {std::max(a, b), c};
  });

  constexpr std::size_t kGrain = 1 << 15;
  std::vector<Index>& first_edge = next; // reused: the number of edges of a smaller vertex, then where they start
  first_edge.resize(n + 1);
  parallel_chunks(n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const std::span<HalfEdge> mine(sorted.data() + bucket[v], sorted.data() + bucket[v + 1]);
      sort_by_target(mine);
      Index count = 0;
      for (std::size_t i = 0; i < mine.size(); ++i) count += i == 0 || mine[i].to != mine[i - 1].to;
      first_edge[v] = count;
    }
  });
  first_edge[n] = 0;
  std::exclusive_scan(first_edge.begin(), first_edge.end(), first_edge.begin(), Index{0});

  Connectivity out;
  const auto edge_count = static_cast<std::size_t>(first_edge[n]);
  out.edges.resize(2 * edge_count);
  out.edge_offsets.resize(edge_count + 1);
  out.edge_offsets[edge_count] = static_cast<Index>(corners.size());
  out.edge_corners.resize(corners.size());
  out.corner_edges.resize(corners.size());
  out.opposite.resize(corners.size());
  parallel_chunks(n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      auto edge = static_cast<std::size_t>(first_edge[v]);
      const auto stop = static_cast<std::size_t>(bucket[v + 1]);
      for (auto i = static_cast<std::size_t>(bucket[v]), j = i; i < stop; i = j, ++edge) {
        while (j < stop && sorted[j].to == sorted[i].to) ++j;
        out.edges[2 * edge] = static_cast<Index>(v);
        out.edges[2 * edge + 1] = sorted[i].to;
        out.edge_offsets[edge] = static_cast<Index>(i);
        link(sorted, i, j, static_cast<Index>(edge), out);
      }
    }
  });
  return out;
}

namespace {

/// Walks along a border. Needs to know the face of a corner, hence an object.
class BorderWalk {
 public:
  BorderWalk(std::span<const Index> offsets, std::span<const Index> corners, const Connectivity& connectivity)
      : offsets_(offsets), corners_(corners), connectivity_(connectivity), face_(corners.size()) {
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f)
      std::fill(face_.begin() + offsets[f], face_.begin() + offsets[f + 1], static_cast<Index>(f));
  }

  [[nodiscard]] Index from(Index corner) const { return corners_[static_cast<std::size_t>(corner)]; }
  [[nodiscard]] Index to(Index corner) const { return from(next(corner)); }

  /// The border half-edge that follows `corner`'s around `pivot`, one of its ends; or kNonManifold.
  [[nodiscard]] Index turn(Index corner, Index pivot) const {
    while (true) {
      corner = to(corner) == pivot ? next(corner) : previous(corner); // the face's other edge at the pivot
      const Index across = connectivity_.opposite[static_cast<std::size_t>(corner)];
      if (across == Connectivity::kBorder) return corner;
      if (across == Connectivity::kNonManifold) return across;
      corner = across;
    }
  }

 private:
  [[nodiscard]] Index face(Index corner) const { return face_[static_cast<std::size_t>(corner)]; }
  [[nodiscard]] Index next(Index corner) const {
    const auto f = static_cast<std::size_t>(face(corner));
    return corner + 1 < offsets_[f + 1] ? corner + 1 : offsets_[f];
  }
  [[nodiscard]] Index previous(Index corner) const {
    const auto f = static_cast<std::size_t>(face(corner));
    return corner > offsets_[f] ? corner - 1 : offsets_[f + 1] - 1;
  }

  std::span<const Index> offsets_;
  std::span<const Index> corners_;
  const Connectivity& connectivity_;
  std::vector<Index> face_;
};

} // namespace

BorderLoops trace_border_loops(std::span<const Index> offsets, std::span<const Index> corners,
                               const Connectivity& connectivity) {
  const BorderWalk walk(offsets, corners, connectivity);
  std::vector<std::uint8_t> visited(corners.size(), 0);
  BorderLoops loops;
  loops.offsets.push_back(0);
  for (Index seed = 0; seed < static_cast<Index>(corners.size()); ++seed) {
    if (connectivity.opposite[static_cast<std::size_t>(seed)] != Connectivity::kBorder) continue;
    const auto begin = static_cast<std::ptrdiff_t>(loops.vertices.size());
    Index corner = seed;
    Index pivot = walk.from(seed);
    while (corner >= 0 && visited[static_cast<std::size_t>(corner)] == 0) {
      visited[static_cast<std::size_t>(corner)] = 1;
      loops.vertices.push_back(pivot);
      pivot = walk.from(corner) == pivot ? walk.to(corner) : walk.from(corner);
      corner = walk.turn(corner, pivot);
    }
    const bool closed = corner == seed && static_cast<std::ptrdiff_t>(loops.vertices.size()) > begin;
    if (!closed) {
      loops.vertices.resize(static_cast<std::size_t>(begin));
      continue;
    }
    const auto loop = loops.vertices.begin() + begin;
    std::rotate(loop, std::min_element(loop, loops.vertices.end()), loops.vertices.end());
    loops.offsets.push_back(static_cast<Index>(loops.vertices.size()));
  }
  return loops;
}

} // namespace dirichlet
