// SPDX-License-Identifier: GPL-3.0-or-later
#include "connectivity.h"

#include <algorithm>
#include <numeric>

#include "index.h"
#include "parallel_collect.h"

namespace dirichlet {
namespace {

/// A half-edge as one number: the larger vertex above, the corner where it starts below. Sorted, those of one edge are
/// neighbours, in ascending order of corners.
using HalfEdge = std::uint64_t;

HalfEdge half_edge(Index larger, Index corner) {
  return static_cast<HalfEdge>(larger) << 32 | static_cast<std::uint32_t>(corner);
}
Index larger_vertex(HalfEdge h) {
  return static_cast<Index>(h >> 32);
}
Index corner(HalfEdge h) {
  return static_cast<Index>(h & 0xFFFF'FFFF);
}

/// The half-edges by their smaller vertex: those of v are half_edges[starts[v]] … half_edges[starts[v + 1]).
struct Buckets {
  Buffer<Index> starts; ///< (V + 1,)
  Buffer<HalfEdge> half_edges;
};

/// Calls visit(corner, from, to) for every half-edge, in ascending order of corners.
template <class Visit>
void for_each_half_edge(std::span<const Index> offsets, std::span<const Index> corners, Visit visit) {
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    const Index begin = offsets[f], last = offsets[f + 1] - 1;
    visit(begin, corners[at(begin)], corners[at(begin) + 1]); // there are three at least: no loop for a triangle
    visit(begin + 1, corners[at(begin) + 1], corners[at(begin) + 2]);
    for (Index c = begin + 2; c < last; ++c) visit(c, corners[at(c)], corners[at(c) + 1]);
    visit(last, corners[at(last)], corners[at(begin)]);
  }
}

/// A counting sort.
Buckets fill_buckets(Index vertex_count, std::span<const Index> offsets, std::span<const Index> corners) {
  Buckets buckets;
  Buffer<Index>& next = buckets.starts; // one place ahead until the end: bucket v is filled up to next[v + 1]
  next.assign(at(vertex_count) + 2, 0);
  for_each_half_edge(offsets, corners, [&](Index, Index a, Index b) { ++next[at(std::min(a, b)) + 2]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  buckets.half_edges.resize(corners.size());
  for_each_half_edge(offsets, corners, [&](Index c, Index a, Index b) {
    buckets.half_edges[at(next[at(std::min(a, b)) + 1]++)] = half_edge(std::max(a, b), c);
  });
  next.pop_back();
  return buckets;
}

/// Most vertices have a handful, and a branch in their sorting would be mispredicted every other time; the hub of a fan
/// may have a million.
void sort_bucket(std::span<HalfEdge> bucket) {
  constexpr std::size_t kInsertion = 24;
  if (bucket.size() > kInsertion) {
    std::sort(bucket.begin(), bucket.end());
    return;
  }
  for (std::size_t i = 1; i < bucket.size(); ++i) {
    HalfEdge inserted = bucket[i];
    for (std::size_t j = i; j-- > 0;) {
      const HalfEdge other = bucket[j];
      const bool before = inserted < other;
      bucket[j + 1] = before ? other : inserted;
      inserted = before ? inserted : other;
    }
    bucket[0] = inserted;
  }
}

/// The half-edges of one edge learn of each other.
void link(std::span<const HalfEdge> edge, Buffer<Index>& opposite) {
  if (edge.size() == 2) {
    opposite[at(corner(edge[0]))] = corner(edge[1]);
    opposite[at(corner(edge[1]))] = corner(edge[0]);
    return;
  }
  for (const HalfEdge h : edge)
    opposite[at(corner(h))] = edge.size() == 1 ? Connectivity::kBorder : Connectivity::kNonManifold;
}

} // namespace

Connectivity build_connectivity(Index vertex_count, std::span<const Index> offsets, std::span<const Index> corners) {
  Buckets buckets = fill_buckets(vertex_count, offsets, corners);
  Connectivity out;
  out.opposite.resize(corners.size());
  constexpr std::size_t kGrain = 1 << 13;
  out.edges = parallel_collect<Index>(at(vertex_count), kGrain, [&](std::size_t begin, std::size_t end, auto& edges) {
    edges.reserve(at(buckets.starts[end] - buckets.starts[begin])); // enough for a closed surface
    for (std::size_t v = begin; v < end; ++v) {
      const std::span bucket(buckets.half_edges.data() + buckets.starts[v],
                             buckets.half_edges.data() + buckets.starts[v + 1]);
      sort_bucket(bucket);
      for (std::size_t i = 0, j = 0; i < bucket.size(); i = j) {
        while (j < bucket.size() && larger_vertex(bucket[j]) == larger_vertex(bucket[i])) ++j;
        edges.push_back(static_cast<Index>(v));
        edges.push_back(larger_vertex(bucket[i]));
        link(bucket.subspan(i, j - i), out.opposite);
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
