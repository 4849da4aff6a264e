// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "connectivity.h"
#include "dirichlet/error.h"
#include "dirichlet/triangulation.h"
#include "message.h"
#include "stopwatch.h"
#include "union_find.h"

namespace dirichlet {
namespace {

/// Squares of coordinates have to stay finite, for lengths and areas.
constexpr double kLargestCoordinate = 1e150;
/// Corners and matrix entries are counted in 32 bits; a corner makes at most two entries.
constexpr std::size_t kMostCorners = std::numeric_limits<Index>::max() / 4;

void check_positions(std::span<const double> positions) {
  if (positions.size() % 3 != 0)
    throw InputError(message("positions have ", positions.size(), " numbers, which is not a multiple of 3"));
  if (positions.size() / 3 > kMostCorners)
    throw InputError(message("a mesh has at most ", kMostCorners, " vertices, not ", positions.size() / 3));
  const auto bad = [](double x) { return !(std::abs(x) <= kLargestCoordinate); };
  const auto first = std::find_if(positions.begin(), positions.end(), bad);
  if (first == positions.end()) return;
  const auto count = std::count_if(first, positions.end(), bad);
  throw InputError(message("vertex ", (first - positions.begin()) / 3, " has the coordinate ", *first,
                           ", which is not finite or beyond 1e150", and_more(count - 1, "coordinate")));
}

void check_offsets(std::span<const Index> offsets, std::size_t corner_count) {
  if (offsets.size() < 2 || corner_count == 0) throw InputError("the mesh has no faces");
  if (corner_count > kMostCorners)
    throw InputError(message("a mesh has at most ", kMostCorners, " corners, not ", corner_count));
  if (offsets.front() != 0 || offsets.back() != static_cast<Index>(corner_count))
    throw InputError(message("face offsets run from ", offsets.front(), " to ", offsets.back(),
                             ", but have to run from 0 to the number of corners, ", corner_count));
  const auto drop = std::is_sorted_until(offsets.begin(), offsets.end());
  if (drop != offsets.end())
    throw InputError(
        message("face offsets descend at place ", drop - offsets.begin(), ", from ", *(drop - 1), " to ", *drop));
}

void check_corner_range(std::span<const Index> offsets, std::span<const Index> corners, Index vertex_count) {
  const auto bad = [=](Index v) { return v < 0 || v >= vertex_count; };
  const auto first = std::find_if(corners.begin(), corners.end(), bad);
  if (first == corners.end()) return;
  const auto place = static_cast<Index>(first - corners.begin());
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), place) - offsets.begin() - 1;
  throw InputError(message("face ", face, " names vertex ", *first, ", but the vertices are 0 to ", vertex_count - 1,
                           and_more(std::count_if(first, corners.end(), bad) - 1, "corner")));
}

/// Copies faces corner by corner, leaves out direct repeats, and refuses what is then not a polygon.
class FaceCopier {
 public:
  explicit FaceCopier(Index vertex_count) : last_face_(static_cast<std::size_t>(vertex_count), -1) {}

  void copy(Index face, std::span<const Index> in, std::vector<Index>& out) {
    if (in.size() == 3 && in[0] != in[1] && in[1] != in[2] && in[2] != in[0]) { // most faces there are
      out.insert(out.end(), in.begin(), in.end());
      return;
    }
    const std::size_t begin = out.size();
    for (const Index v : in)
      if (out.size() == begin || out.back() != v) out.push_back(v);
    while (out.size() > begin + 1 && out.back() == out[begin]) out.pop_back();
    if (out.size() < begin + 3)
      throw TopologyError(message("face ", face, " has fewer than three different vertices", naming(in)));
    for (std::size_t i = begin; i < out.size(); ++i) {
      Index& last = last_face_[static_cast<std::size_t>(out[i])];
      if (last == face) throw TopologyError(message("face ", face, " names vertex ", out[i], " twice"));
      last = face;
    }
  }

 private:
  static std::string naming(std::span<const Index> corners) {
    return corners.empty() ? ": it has no corners" : message(": it begins with vertex ", corners.front());
  }
  std::vector<Index> last_face_; ///< the face that named a vertex last
};

} // namespace

Mesh::Mesh(SharedArray<double> positions, std::span<const Index> offsets, std::span<const Index> corners)
    : positions_(std::move(positions)) {
  build(offsets, corners);
}

Mesh::Mesh(SharedArray<double> positions, std::span<const Index> corners, Index corners_per_face)
    : positions_(std::move(positions)) {
  if (corners_per_face < 1 || corners.size() % static_cast<std::size_t>(corners_per_face) != 0)
    throw InputError(message(corners.size(), " corners do not make faces of ", corners_per_face));
  if (corners.size() > kMostCorners)
    throw InputError(message("a mesh has at most ", kMostCorners, " corners, not ", corners.size()));
  std::vector<Index> offsets(corners.size() / static_cast<std::size_t>(corners_per_face) + 1);
  for (std::size_t f = 0; f < offsets.size(); ++f) offsets[f] = static_cast<Index>(f) * corners_per_face;
  build(offsets, corners);
}

void Mesh::build(std::span<const Index> offsets, std::span<const Index> corners) {
  const Stopwatch watch;
  check_positions(positions_.view());
  check_offsets(offsets, corners.size());
  check_corner_range(offsets, corners, vertex_count());

  offsets_.reserve(offsets.size());
  corners_.reserve(corners.size());
  offsets_.push_back(0);
  FaceCopier copier(vertex_count());
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
    const auto begin = static_cast<std::size_t>(offsets[f]), end = static_cast<std::size_t>(offsets[f + 1]);
    copier.copy(static_cast<Index>(f), corners.subspan(begin, end - begin), corners_);
    offsets_.push_back(static_cast<Index>(corners_.size()));
  }
  triangular_ = true;
  for (std::size_t f = 0; f + 1 < offsets_.size() && triangular_; ++f) triangular_ = offsets_[f + 1] - offsets_[f] == 3;
  connectivity_ = build_connectivity(vertex_count(), offsets_, corners_);
  build_seconds_ = watch.seconds();
}

const Mesh& Mesh::triangulated() const {
  if (triangular_) return *this;
  std::call_once(triangulate_once_, [this] {
    triangulated_ = std::make_unique<Mesh>(positions_, triangulate(positions(), offsets_, corners_), 3);
  });
  return *triangulated_;
}

Components Mesh::components() const {
  UnionFind sets(vertex_count());
  const auto& edges = connectivity_.edges;
  for (std::size_t e = 0; e < edges.size(); e += 2) sets.unite(edges[e], edges[e + 1]);
  Components result;
  result.label.resize(static_cast<std::size_t>(vertex_count()));
  result.count = sets.label([](Index) { return true; }, result.label);
  return result;
}

BorderLoops Mesh::border_loops() const {
  return trace_border_loops(offsets_, corners_, connectivity_);
}

} // namespace dirichlet
