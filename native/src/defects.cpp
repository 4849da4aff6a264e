// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/defects.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "index.h"
#include "message.h"
#include "parallel_collect.h"
#include "vector3.h"

namespace dirichlet {
namespace {

/// Twice the area vector of a polygon, relative to its first corner, which keeps what is small beside an offset.
Vector3 area_vector(std::span<const double> positions, std::span<const Index> face, double scale) {
  const auto point = [&](Index v) {
    const double* p = positions.data() + 3 * at(v);
    return Vector3{p[0], p[1], p[2]};
  };
  const Vector3 origin = point(face[0]);
  Vector3 sum, last = scale * (point(face[1]) - origin);
  for (const Index v : face.subspan(2)) {
    const Vector3 next = scale * (point(v) - origin);
    sum = sum + cross(last, next);
    last = next;
  }
  return sum;
}

bool is_zero(const Vector3& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

/// Whether a face has no area; products that vanish for being small are made anew in a scale where they do not.
bool is_flat(std::span<const double> positions, std::span<const Index> face) {
  if (!is_zero(area_vector(positions, face, 1))) return false;
  double size = 0;
  for (const Index v : face)
    for (std::size_t axis = 0; axis < 3; ++axis)
      size = std::max(size, std::abs(positions[3 * at(v) + axis] - positions[3 * at(face[0]) + axis]));
  return is_zero(area_vector(positions, face, unit_scale(size)));
}

void find_flat_faces(const Mesh& mesh, Defects& defects) {
  constexpr std::size_t kGrain = 1 << 14;
  const auto flat = parallel_collect<Index>(
      at(mesh.face_count()), kGrain, [&](std::size_t begin, std::size_t end, Buffer<Index>& found) {
        for (std::size_t f = begin; f < end; ++f) {
          const auto first = at(mesh.offsets()[f]), last = at(mesh.offsets()[f + 1]);
          if (is_flat(mesh.positions(), mesh.corners().subspan(first, last - first)))
            found.push_back(static_cast<Index>(f));
        }
      });
  defects.flat_faces = static_cast<Index>(flat.size());
  if (!flat.empty()) defects.first_flat = flat.front();
}

/// The ends of border edges, ascending.
std::vector<Index> border_vertices(const Mesh& mesh) {
  const auto& opposite = mesh.connectivity().opposite;
  if (std::find(opposite.begin(), opposite.end(), Connectivity::kBorder) == opposite.end()) return {};
  std::vector<std::uint8_t> is_border(at(mesh.vertex_count()), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.offsets()[at(f)], end = mesh.offsets()[at(f) + 1];
    for (Index c = begin; c < end; ++c)
      if (opposite[at(c)] == Connectivity::kBorder)
        is_border[at(mesh.corners()[at(c)])] = is_border[at(mesh.corners()[at(c + 1 < end ? c + 1 : begin)])] = 1;
  }
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (is_border[at(v)] != 0) vertices.push_back(v);
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

void find_coincident_vertices(const Mesh& mesh, Defects& defects) {
  const std::vector<Index> vertices = border_vertices(mesh);
  Places places(mesh.positions(), vertices.size());
  for (const Index v : vertices)
    if (const Index first = places.put(v); first != v && defects.coincident_vertices++ == 0)
      defects.first_coincident = {first, v};
}

} // namespace

std::vector<std::string> Defects::warnings() const {
  std::vector<std::string> texts;
  if (repeated_faces > 0)
    texts.push_back(message("face ", first_repeat[0], " repeats face ", first_repeat[1],
                            and_more(repeated_faces - 1, "repeated face"), ", and counts once"));
  if (flat_faces > 0) texts.push_back(message("face ", first_flat, " has no area", and_more(flat_faces - 1, "face")));
  if (coincident_vertices > 0)
    texts.push_back(
        message(coincident_vertices, coincident_vertices == 1 ? " pair" : " pairs",
                " of vertices coincide (the first: ", first_coincident[0], " and ", first_coincident[1],
                ") without being joined, and the field breaks off there; merging by distance would join them"));
  return texts;
}

Defects find_defects(const Mesh& mesh) {
  Defects defects;
  const auto repeats = mesh.repeated_faces();
  defects.repeated_faces = static_cast<Index>(repeats.size());
  if (!repeats.empty()) defects.first_repeat = repeats.front();
  find_flat_faces(mesh, defects);
  find_coincident_vertices(mesh, defects);
  return defects;
}

} // namespace dirichlet
