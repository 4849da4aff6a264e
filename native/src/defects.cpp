// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/defects.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <set>
#include <span>
#include <utility>

#include "dirichlet/triangulation.h"
#include "index.h"
#include "message.h"
#include "union_find.h"

namespace dirichlet {
namespace {

/// (V,) 1 for the ends of border edges; empty where there are none.
std::vector<std::uint8_t> mark_border(const Mesh& mesh) {
  std::vector<std::uint8_t> is_border;
  const auto& opposite = mesh.connectivity().opposite;
  if (std::find(opposite.begin(), opposite.end(), Connectivity::kBorder) == opposite.end()) return is_border;
  is_border.resize(at(mesh.vertex_count()), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.offsets()[at(f)], end = mesh.offsets()[at(f) + 1];
    for (Index c = begin; c < end; ++c)
      if (opposite[at(c)] == Connectivity::kBorder)
        is_border[at(mesh.corners()[at(c)])] = is_border[at(mesh.corners()[at(c + 1 < end ? c + 1 : begin)])] = 1;
  }
  return is_border;
}

/// (V,) 1 for the vertices of faces that are inside, where the faces make several pieces: else none of them can be
/// where a vertex of another piece is.
std::vector<std::uint8_t> mark_inside(const Mesh& mesh, const Components& pieces,
                                      std::span<const std::uint8_t> border) {
  std::vector<std::uint8_t> is_inside;
  const auto label = [&](Index corner) { return pieces.label[at(corner)]; };
  const auto corners = mesh.corners();
  if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return label(v) == label(corners[0]); }))
    return is_inside;
  is_inside.resize(at(mesh.vertex_count()), 0);
  for (const Index v : corners) is_inside[at(v)] = border.empty() || border[at(v)] == 0 ? 1 : 0;
  return is_inside;
}

std::vector<Index> marked(std::span<const std::uint8_t> marks) {
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < marks.size(); ++v)
    if (marks[v] != 0) vertices.push_back(static_cast<Index>(v));
  return vertices;
}

/// Vertices by their place, exactly: a hash table of the first vertex at every place.
class Places {
 public:
  Places(std::span<const double> positions, std::size_t most)
      : positions_(positions), slots_(std::bit_ceil(2 * most), -1) {}

  /// The vertex that was put first where `vertex` is: itself, if there was none.
  Index put(Index vertex) {
    for (std::size_t i = hash(vertex);; ++i) {
      Index& slot = slots_[i & (slots_.size() - 1)];
      if (slot < 0) slot = vertex;
      if (std::equal(place(slot), place(slot) + 3, place(vertex))) return slot;
    }
  }

 private:
  [[nodiscard]] const double* place(Index vertex) const { return positions_.data() + 3 * at(vertex); }
  [[nodiscard]] std::size_t hash(Index vertex) const {
    std::uint64_t mixed = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mixed ^= std::bit_cast<std::uint64_t>(place(vertex)[axis] + 0.0); // -0 is where 0 is
      mixed *= 0x9E37'79B9'7F4A'7C15;
      mixed ^= mixed >> 29;
    }
    return static_cast<std::size_t>(mixed);
  }

  std::span<const double> positions_;
  std::vector<Index> slots_;
};

/// Those that edges without length join are one vertex here: there is no gap between them.
UnionFind joined_vertices(const Mesh& mesh) {
  UnionFind sets(mesh.vertex_count());
  const auto& edges = mesh.connectivity().edges;
  const double* const positions = mesh.positions().data();
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    const double *one = positions + 3 * at(edges[e]), *other = positions + 3 * at(edges[e + 1]);
    if (std::equal(one, one + 3, other)) sets.unite(edges[e], edges[e + 1]);
  }
  return sets;
}

void find_coincident_vertices(const Mesh& mesh, const Components& pieces, Defects& defects) {
  const auto is_border = mark_border(mesh);
  const auto border = marked(is_border), inside = marked(mark_inside(mesh, pieces, is_border));
  Places places(mesh.positions(), border.size() + inside.size());
  std::vector<std::array<Index, 2>> pairs;
  for (const Index v : border)
    if (const Index first = places.put(v); first != v) pairs.push_back({first, v});
  std::set<std::pair<Index, Index>> met; // a place, by who is first there, and a piece
  for (const Index v : inside)           // after those on a border, which come first in their place
    if (const Index first = places.put(v), piece = pieces.label[at(v)];
        pieces.label[at(first)] != piece && met.insert({first, piece}).second)
      pairs.push_back({std::min(first, v), std::max(first, v)});
  if (pairs.empty()) return;
  std::sort(pairs.begin(), pairs.end(),
            [](const auto& a, const auto& b) { return std::pair(a[1], a[0]) < std::pair(b[1], b[0]); });
  UnionFind joined = joined_vertices(mesh);
  for (const auto& [first, v] : pairs) {
    if (joined.find(first) == joined.find(v)) continue;
    joined.unite(first, v); // others joined to this one count no more
    if (defects.coincident_vertices++ == 0) defects.first_coincident = {first, v};
  }
}

} // namespace

std::vector<std::string> Defects::warnings() const {
  std::vector<std::string> texts;
  if (repeated_faces > 0)
    texts.push_back(message("face ", first_repeat[0], " repeats face ", first_repeat[1],
                            and_more(repeated_faces - 1, "repeated face"), ", and counts once"));
  if (flat_faces > 0) texts.push_back(message("face ", first_flat, " has no area", and_more(flat_faces - 1, "face")));
  if (crossing_faces > 0)
    texts.push_back(message("face ", first_crossing, " crosses itself", and_more(crossing_faces - 1, "face"),
                            ", so its triangles lie on each other"));
  if (coincident_vertices > 0)
    texts.push_back(
        message(coincident_vertices, coincident_vertices == 1 ? " pair" : " pairs",
                " of vertices coincide (the first: ", first_coincident[0], " and ", first_coincident[1],
                ") without being joined, and the field breaks off there; merging by distance would join them"));
  return texts;
}

Defects find_defects(const Mesh& mesh) {
  return find_defects(mesh, mesh.components());
}

Defects find_defects(const Mesh& mesh, const Components& pieces) {
  Defects defects;
  const auto repeats = mesh.repeated_faces();
  defects.repeated_faces = static_cast<Index>(repeats.size());
  if (!repeats.empty()) defects.first_repeat = repeats.front();
  const auto flat = mesh.flat_faces();
  defects.flat_faces = static_cast<Index>(flat.size());
  if (!flat.empty()) defects.first_flat = flat.front();
  if (!mesh.is_triangular()) {
    const auto crossing = mesh.each_once(find_crossing_faces(mesh.positions(), mesh.offsets(), mesh.corners()));
    defects.crossing_faces = static_cast<Index>(crossing.size());
    if (!crossing.empty()) defects.first_crossing = crossing.front();
  }
  find_coincident_vertices(mesh, pieces, defects);
  return defects;
}

} // namespace dirichlet
