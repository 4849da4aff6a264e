// SPDX-License-Identifier: GPL-3.0-or-later
#include "dirichlet/patches.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

#include <algorithm>

#include "dirichlet/error.h"
#include "groups.h"
#include "index.h"
#include "message.h"
#include "openmesh_session.h"
#include "union_find.h"

namespace dirichlet {
namespace {

using HalfEdgeMesh = OpenMesh::PolyConnectivity; // a half-edge mesh without coordinates

void check_range(std::span<const std::vector<Index>> patches, Index vertex_count) {
  const auto bad = [=](Index v) { return v < 0 || v >= vertex_count; };
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto first = std::find_if(patches[p].begin(), patches[p].end(), bad);
    if (first == patches[p].end()) continue;
    throw InputError(message("patch ", p, " names vertex ", *first, ", but the vertices are 0 to ", vertex_count - 1,
                             and_more(std::count_if(first, patches[p].end(), bad) - 1, "number")));
  }
}

/// Border loops of a half-edge mesh: OpenMesh links the half-edges of a border to each other.
Index count_border_loops(const HalfEdgeMesh& surface) {
  std::vector<bool> seen(surface.n_halfedges());
  Index loops = 0;
  for (const auto start : surface.halfedges()) {
    if (!surface.is_boundary(start) || seen[at(start.idx())]) continue;
    ++loops;
    for (OpenMesh::HalfedgeHandle h = start; !seen[at(h.idx())]; h = surface.next_halfedge_handle(h))
      seen[at(h.idx())] = true;
  }
  return loops;
}

/// Looks at one patch after the other. What is found by vertex or face is sorted once; a patch then costs its one-ring.
class PatchInspector {
 public:
  explicit PatchInspector(const Mesh& mesh)
      : mesh_(mesh), edges_by_vertex_(at(mesh.vertex_count()), smaller_ends(mesh)),
        faces_by_vertex_(at(mesh.vertex_count()), first_corners(mesh)), face_of_corner_(mesh.corners().size()),
        local_(at(mesh.vertex_count()), kOutside), side_(at(mesh.face_count()), Side::outside) {
    for (Index f = 0; f < mesh.face_count(); ++f)
      std::fill_n(face_of_corner_.begin() + mesh.offsets()[at(f)], face(f).size(), f);
  }

  /// \param vertices  ascending, each once
  PatchFacts inspect(std::span<const Index> vertices) {
    enter(vertices);
    PatchFacts facts;
    facts.vertices = static_cast<Index>(vertices.size());
    facts.faces = static_cast<Index>(faces_.size());
    span_by_edges(vertices, facts);
    facts.euler_characteristic = facts.vertices - facts.edges + facts.faces;
    build_surface(facts);
    leave(vertices);
    return facts;
  }

 private:
  static constexpr Index kOutside = -1;
  enum class Side : signed char { outside, waiting, kept, flipped };

  static std::vector<Index> smaller_ends(const Mesh& mesh) {
    std::vector<Index> ends(at(mesh.edge_count()));
    for (std::size_t e = 0; e < ends.size(); ++e) ends[e] = mesh.connectivity().edges[2 * e];
    return ends;
  }
  static std::vector<Index> first_corners(const Mesh& mesh) {
    std::vector<Index> corners(at(mesh.face_count()));
    for (std::size_t f = 0; f < corners.size(); ++f) corners[f] = mesh.corners()[at(mesh.offsets()[f])];
    return corners;
  }

  [[nodiscard]] std::span<const Index> face(Index f) const {
    const Index begin = mesh_.offsets()[at(f)];
    return mesh_.corners().subspan(at(begin), at(mesh_.offsets()[at(f) + 1] - begin));
  }

  void enter(std::span<const Index> vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) local_[at(vertices[i])] = static_cast<Index>(i);
    for (const Index v : vertices)
      for (const Index f : faces_by_vertex_[v])
        if (std::ranges::all_of(face(f), [&](Index w) { return local_[at(w)] != kOutside; })) {
          faces_.push_back(f);
          side_[at(f)] = Side::waiting;
        }
  }

  void leave(std::span<const Index> vertices) {
    for (const Index v : vertices) local_[at(v)] = kOutside;
    for (const Index f : faces_) side_[at(f)] = Side::outside;
    faces_.clear();
  }

  void span_by_edges(std::span<const Index> vertices, PatchFacts& facts) {
    UnionFind pieces(facts.vertices);
    facts.components = facts.vertices;
    for (const Index v : vertices)
      for (const Index e : edges_by_vertex_[v]) {
        const Index other = local_[at(mesh_.connectivity().edges[2 * at(e) + 1])];
        if (other == kOutside) continue;
        ++facts.edges;
        if (pieces.find(local_[at(v)]) != pieces.find(other)) --facts.components;
        pieces.unite(local_[at(v)], other);
      }
  }

  /// Half-edges know one orientation, the mesh need not have one: turns every face like its neighbour.
  void orient() {
    std::vector<Index> front;
    for (const Index seed : faces_) {
      if (side_[at(seed)] != Side::waiting) continue;
      side_[at(seed)] = Side::kept;
      for (front = {seed}; !front.empty();) {
        const Index f = front.back();
        front.pop_back();
        for (Index c = mesh_.offsets()[at(f)]; c < mesh_.offsets()[at(f) + 1]; ++c) turn_neighbour(f, c, front);
      }
    }
  }

  void turn_neighbour(Index f, Index corner, std::vector<Index>& front) {
    const Index opposite = mesh_.connectivity().opposite[at(corner)];
    if (opposite < 0) return;
    Side& side = side_[at(face_of_corner_[at(opposite)])];
    if (side != Side::waiting) return;
    const bool against = mesh_.corners()[at(corner)] == mesh_.corners()[at(opposite)];
    side = against == (side_[at(f)] == Side::kept) ? Side::flipped : Side::kept;
    front.push_back(face_of_corner_[at(opposite)]);
  }

  /// The faces as a half-edge mesh; OpenMesh refuses one that is not manifold.
  void build_surface(PatchFacts& facts) {
    if (faces_.empty()) return;
    orient();
    const OpenMeshSession session;
    HalfEdgeMesh surface;
    for (Index v = 0; v < facts.vertices; ++v) surface.add_vertex();
    std::vector<OpenMesh::VertexHandle> corners;
    for (const Index f : faces_) {
      corners.clear();
      for (const Index v : face(f)) corners.emplace_back(local_[at(v)]);
      if (side_[at(f)] == Side::flipped) std::ranges::reverse(corners);
      if (!surface.add_face(corners).is_valid()) return;
    }
    for (const auto v : surface.vertices())
      if (!surface.is_manifold(v)) return;
    facts.manifold = true;
    facts.border_loops = count_border_loops(surface);
    facts.disc = facts.components == 1 && facts.euler_characteristic == 1 && facts.border_loops == 1 &&
                 at(facts.edges) == surface.n_edges();
  }

  const Mesh& mesh_;
  Groups edges_by_vertex_; ///< the edges whose smaller end it is
  Groups faces_by_vertex_; ///< the faces whose first corner it is
  std::vector<Index> face_of_corner_;
  std::vector<Index> local_; ///< place in the patch at hand
  std::vector<Side> side_;   ///< of every face, for the patch at hand
  std::vector<Index> faces_; ///< of the patch at hand
};

/// Which patches share a vertex. Cost: the patches' sizes, and for each the patches met at its vertices until all
/// others are known.
void find_overlaps(std::span<const std::vector<Index>> patches, Index vertex_count, std::vector<PatchFacts>& facts) {
  std::vector<Index> vertex_of, patch_of;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    vertex_of.insert(vertex_of.end(), patches[p].begin(), patches[p].end());
    patch_of.insert(patch_of.end(), patches[p].size(), static_cast<Index>(p));
  }
  const Groups entries(at(vertex_count), vertex_of);
  std::vector<std::size_t> met_by(patches.size(), patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    auto& overlaps = facts[p].overlaps;
    met_by[p] = p;
    for (auto v = patches[p].begin(); v != patches[p].end() && overlaps.size() + 1 < patches.size(); ++v)
      for (const Index entry : entries[*v]) {
        const Index other = patch_of[at(entry)];
        if (std::exchange(met_by[at(other)], p) != p) overlaps.push_back(other);
      }
    std::ranges::sort(overlaps);
  }
}

} // namespace

std::vector<PatchFacts> inspect_patches(const Mesh& mesh, std::span<const std::vector<Index>> patches) {
  check_range(patches, mesh.vertex_count());
  std::vector<std::vector<Index>> sorted(patches.begin(), patches.end());
  PatchInspector inspector(mesh);
  std::vector<PatchFacts> facts;
  facts.reserve(patches.size());
  for (auto& patch : sorted) {
    std::ranges::sort(patch);
    patch.erase(std::unique(patch.begin(), patch.end()), patch.end());
    facts.push_back(inspector.inspect(patch));
  }
  find_overlaps(sorted, mesh.vertex_count(), facts);
  return facts;
}

} // namespace dirichlet
