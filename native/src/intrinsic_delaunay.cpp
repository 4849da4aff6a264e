// SPDX-License-Identifier: GPL-3.0-or-later
#include "intrinsic_delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "edge_weights.h"
#include "index.h"
#include "intrinsic/cover.h"
#include "message.h"
#include "parallel_collect.h"

namespace dirichlet {
namespace {

constexpr std::size_t kGrain = 1 << 13;

struct WeightedEdges {
  Buffer<Index> edges;
  Buffer<double> weights;
};

/// Of each edge one half-edge.
template <class T, class Visit>
Buffer<T> for_edges(const Buffer<IntrinsicTriangulation::HalfEdge>& half_edges, const Visit& visit) {
  return parallel_collect<T>(half_edges.size(), kGrain, [&](std::size_t begin, std::size_t end, auto& found) {
    found.reserve(end - begin);
    for (auto h = static_cast<Index>(begin); h < static_cast<Index>(end); ++h)
      if (const Index t = half_edges[at(h)].twin; t == IntrinsicTriangulation::kBorder || h < t) visit(h, t, found);
  });
}

/// What rounding cannot tell from 0 or below, and a border's negative weight, becomes so little that no field shows it.
/// Not 0: every triangle joins its vertices, since at most one of its angles is obtuse.
double weight(double one, double other) {
  return std::max(one + other, std::numeric_limits<double>::epsilon() * (std::abs(one) + std::abs(other)));
}

std::vector<std::array<Index, 2>> obtuse_edges(const Buffer<IntrinsicTriangulation::HalfEdge>& half_edges) {
  std::vector<std::array<Index, 2>> found;
  for (Index h = 0; h < static_cast<Index>(half_edges.size()); ++h)
    if (const auto& [twin, tail, half_cotangent] = half_edges[at(h)];
        twin == IntrinsicTriangulation::kBorder && half_cotangent < -0.5) {
      const auto ends = std::minmax(tail, half_edges[at(next_in_triangle(h))].tail);
      found.push_back({ends.first, ends.second});
    }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end()); // of two sheets
  return found;
}

WeightedEdges weighted_edges(const Mesh& mesh, std::span<const double> half_cotangents, DelaunayNotes& notes) {
  Cover sheets = cover(mesh, half_cotangents);
  const Index unflipped = (sheets.triangles.make_delaunay() + sheets.sheets - 1) / sheets.sheets;
  const Buffer<IntrinsicTriangulation::HalfEdge>& half_edges = sheets.triangles.half_edges();
  notes = {sheets.thickened, unflipped, obtuse_edges(half_edges)};
  WeightedEdges all;
  all.edges = for_edges<Index>(half_edges, [&](Index h, Index, auto& found) {
    found.push_back(half_edges[at(h)].tail);
    found.push_back(half_edges[at(next_in_triangle(h))].tail);
  });
  all.weights = for_edges<double>(half_edges, [&](Index h, Index t, auto& found) {
    const double other = t == IntrinsicTriangulation::kBorder ? 0.0 : half_edges[at(t)].half_cotangent;
    found.push_back(weight(half_edges[at(h)].half_cotangent, other) / sheets.sheets);
  });
  return all;
}

} // namespace

std::vector<std::string> DelaunayNotes::warnings() const {
  std::vector<std::string> texts;
  if (thickened > 0)
    texts.push_back(message(thickened, thickened == 1 ? " triangle has" : " triangles have",
                            " an angle within 5e-7 of 180 degrees or hardly a side, and the intrinsic Delaunay "
                            "Laplacian takes ",
                            thickened == 1 ? "it" : "them", " as thicker: the field around may be off by percents"));
  if (unflipped > 0)
    texts.push_back(message("flips of edges were given up as they took too long, and the intrinsic Delaunay Laplacian "
                            "leaves out the negative ",
                            unflipped == 1 ? "weight of " : "weights of ", counted(unflipped, "edge"),
                            ": the field there may be off by percents; thicker triangles take fewer flips"));
  return texts;
}

SparseMatrix intrinsic_delaunay_stiffness(const Mesh& mesh, std::span<const double> half_cotangents,
                                          DelaunayNotes& notes) {
  const WeightedEdges all = weighted_edges(mesh, half_cotangents, notes);
  return stiffness_of_edges(mesh.vertex_count(), all.edges, all.weights);
}

} // namespace dirichlet
