// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "connectivity.h"
#include "dirichlet/error.h"
#include "dirichlet/triangulation.h"
#include "flat_faces.h"
#include "groups.h"
#include "index.h"
#include "mesh_checks.h"
#include "message.h"
#include "repeated_faces.h"
#include "stopwatch.h"
#include "union_find.h"

namespace dirichlet {
namespace {

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

Mesh::Mesh(const Mesh& whole, std::vector<Index> left_out)
    : positions_(whole.positions_), left_out_(std::move(left_out)) {
  Buffer<Index> offsets(1, 0), corners;
  auto out = left_out_.begin();
  for (Index f = 0; f < whole.face_count(); ++f) {
    if (out != left_out_.end() && f == *out) {
      ++out;
      continue;
    }
    const auto all = whole.corners_.begin();
    corners.insert(corners.end(), all + whole.offsets_[at(f)], all + whole.offsets_[at(f) + 1]);
    offsets.push_back(static_cast<Index>(corners.size()));
  }
  build(std::move(offsets), corners);
}

Mesh::Mesh(const Mesh& faces, SharedArray<double> positions)
    : positions_(std::move(positions)), triangular_(faces.triangular_), left_out_(faces.left_out_) {
  const Stopwatch watch;
  check_positions(positions_.view());
  if (vertex_count() != faces.vertex_count())
    throw InputError(
        message("positions of ", vertex_count(), " vertices do not fit faces over ", faces.vertex_count()));
  offsets_ = faces.offsets_;
  corners_ = faces.corners_;
  connectivity_ = faces.connectivity_;
  build_seconds_ = watch.seconds();
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
  return *triangulated_.get([this] {
    return std::make_unique<const Mesh>(positions_, triangulate(positions(), offsets_, corners_, left_out_), 3);
  });
}

std::span<const std::array<Index, 2>> Mesh::repeated_faces() const {
  return repeated_faces_.get([this] { return find_repeated_faces(offsets_, corners_, connectivity_); });
}

std::unique_ptr<const Mesh> Mesh::leave_out(std::vector<Index> faces) const {
  return std::unique_ptr<const Mesh>(new Mesh(*this, std::move(faces))); // its constructor is private
}

const Mesh& Mesh::without_repeats() const {
  if (repeated_faces().empty()) return *this;
  return *without_repeats_.get([this] {
    std::vector<Index> faces;
    for (const auto& [face, first] : repeated_faces()) faces.push_back(face);
    return leave_out(std::move(faces));
  });
}

const Mesh& Mesh::without_inner_repeats() const {
  std::vector<Index> inner; // found anew, as that is nothing beside any use of the mesh
  for (const auto& [face, first] : repeated_faces())
    if (std::all_of(connectivity_.opposite.begin() + offsets_[at(face)],
                    connectivity_.opposite.begin() + offsets_[at(face) + 1],
                    [](Index other) { return other == Connectivity::kNonManifold; }))
      inner.push_back(face);
  if (inner.empty()) return *this;
  if (inner.size() == repeated_faces().size()) return without_repeats();
  return *without_inner_repeats_.get([&] { return leave_out(std::move(inner)); });
}

Index Mesh::number_with_repeats(Index face) const {
  return number_among_all(face, left_out_);
}

std::span<const Index> Mesh::flat_faces() const {
  return flat_faces_.get([this] { return each_once(find_flat_faces(positions(), offsets_, corners_)); });
}

std::vector<Index> Mesh::each_once(std::span<const Index> faces) const {
  std::vector<Index> once;
  if (faces.empty()) return once; // without a look for repeats
  auto repeat = repeated_faces().begin();
  for (const Index face : faces) {
    while (repeat != repeated_faces().end() && (*repeat)[0] < face) ++repeat;
    if (repeat == repeated_faces().end() || (*repeat)[0] != face) once.push_back(face);
  }
  return once;
}

const Groups& Mesh::corners_by_vertex() const {
  return *corners_by_vertex_.get([this] { return std::make_shared<const Groups>(at(vertex_count()), corners_); });
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
