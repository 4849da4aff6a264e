// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "any_value.h"
#include "connectivity.h"
#include "dirichlet/error.h"
#include "dirichlet/triangulation.h"
#include "groups.h"
#include "index.h"
#include "message.h"
#include "repeated_faces.h"
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
  if (!any_value(positions, bad)) return;
  const auto first = std::find_if(positions.begin(), positions.end(), bad);
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
  const auto bad = [=](Index v) { return (v < 0) | (v >= vertex_count); }; // NOLINT(hicpp-signed-bitwise)
  if (!any_value(corners, bad)) return;
  const auto first = std::find_if(corners.begin(), corners.end(), bad);
  const auto place = static_cast<Index>(first - corners.begin());
  const auto face = std::upper_bound(offsets.begin(), offsets.end(), place) - offsets.begin() - 1;
  throw InputError(message("face ", face, " names vertex ", *first, ", but the vertices are 0 to ", vertex_count - 1,
                           and_more(std::count_if(first, corners.end(), bad) - 1, "corner")));
}

bool are_triangles(std::span<const Index> offsets) {
  int others = 0;
  for (std::size_t f = 0; f + 1 < offsets.size(); ++f) others |= offsets[f + 1] - offsets[f] - 3;
  return others == 0;
}

bool are_proper_triangles(std::span<const Index> corners) {
  int repeats = 0;
  for (std::size_t c = 0; c < corners.size(); c += 3) {
    const Index i = corners[c], j = corners[c + 1], k = corners[c + 2];
    repeats |= static_cast<int>(i == j) | static_cast<int>(j == k) | static_cast<int>(k == i);
  }
  return repeats == 0;
}

/// Leaves out direct repeats, in place, and refuses what is then not a polygon.
class FaceCleaner {
 public:
  explicit FaceCleaner(Index vertex_count) : last_face_(at(vertex_count), -1) {}

  void clean(Buffer<Index>& offsets, Buffer<Index>& corners) {
    Index* to = corners.data();
    std::size_t begin = 0;
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
      const std::size_t end = at(offsets[f + 1]);
      offsets[f] = static_cast<Index>(to - corners.data());
      to = move(static_cast<Index>(f), {corners.data() + begin, end - begin}, to);
      begin = end;
    }
    offsets.back() = static_cast<Index>(to - corners.data());
    corners.resize(at(offsets.back()));
    if (refused_ > 0) throw TopologyError(first_refusal_ + and_more(refused_ - 1, "such face"));
  }

 private:
  /// Moves a face to `to`, at or before its place. \returns where it then ends.
  Index* move(Index face, std::span<const Index> in, Index* to) {
    const Index front = in.empty() ? -1 : in.front();
    Index* end = to;
    for (const Index v : in)
      if (end == to || end[-1] != v) *end++ = v;
    while (end - to > 1 && end[-1] == *to) --end;
    if (end - to < 3)
      refuse(message("face ", face, " has fewer than three different vertices: it ",
                     front < 0 ? "has no corners" : message("begins with vertex ", front)));
    else if (const Index* const twice = std::find_if(to, end, [&](Index v) { return visited(face, v); }); twice != end)
      refuse(message("face ", face, " names vertex ", *twice, " twice"));
    return end;
  }

  bool visited(Index face, Index vertex) { return std::exchange(last_face_[at(vertex)], face) == face; }

  void refuse(const std::string& why) {
    if (refused_++ == 0) first_refusal_ = why;
  }

  std::vector<Index> last_face_; ///< the face that named a vertex last
  Index refused_ = 0;
  std::string first_refusal_;
};

} // namespace

Mesh::Mesh(SharedArray<double> positions, std::span<const Index> offsets, std::span<const Index> corners)
    : positions_(std::move(positions)) {
  build({offsets.begin(), offsets.end()}, corners);
}

Mesh::Mesh(SharedArray<double> positions, std::span<const Index> corners, Index corners_per_face)
    : positions_(std::move(positions)) {
  if (corners_per_face < 1 || corners.size() % static_cast<std::size_t>(corners_per_face) != 0)
    throw InputError(message(counted(corners.size(), "corner"), corners.size() == 1 ? " does" : " do",
                             " not make faces of ", corners_per_face));
  if (corners.size() > kMostCorners)
    throw InputError(message("a mesh has at most ", kMostCorners, " corners, not ", corners.size()));
  Buffer<Index> offsets(corners.size() / at(corners_per_face) + 1);
  for (std::size_t f = 0; f < offsets.size(); ++f) offsets[f] = static_cast<Index>(f) * corners_per_face;
  build(std::move(offsets), corners);
}

void Mesh::build(Buffer<Index> offsets, std::span<const Index> corners) {
  const Stopwatch watch;
  check_positions(positions_.view());
  check_offsets(offsets, corners.size());
  check_corner_range(offsets, corners, vertex_count());

  offsets_ = std::move(offsets);
  corners_.assign(corners.begin(), corners.end());
  triangular_ = are_triangles(offsets_);
  if (!triangular_ || !are_proper_triangles(corners_)) {
    FaceCleaner(vertex_count()).clean(offsets_, corners_);
    triangular_ = are_triangles(offsets_);
  }
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

std::span<const std::array<Index, 2>> Mesh::repeated_faces() const {
  std::call_once(find_repeats_once_,
                 [this] { repeated_faces_ = find_repeated_faces(offsets_, corners_, connectivity_); });
  return repeated_faces_;
}

const Mesh& Mesh::without_repeats() const {
  const auto repeats = repeated_faces();
  if (repeats.empty()) return *this;
  std::call_once(leave_out_repeats_once_, [&] {
    std::vector<Index> faces;
    for (const auto& [face, first] : repeats) faces.push_back(face);
    without_repeats_ = leave_out(*this, faces);
  });
  return *without_repeats_;
}

const Groups& Mesh::corners_by_vertex() const {
  std::call_once(group_corners_once_,
                 [this] { corners_by_vertex_ = std::make_shared<const Groups>(at(vertex_count()), corners_); });
  return *corners_by_vertex_;
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
