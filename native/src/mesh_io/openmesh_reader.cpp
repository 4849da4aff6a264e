// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io/openmesh_reader.h"

// MeshIO.hh registers the readers where OpenMesh is linked statically; it has to come first.
#include <OpenMesh/Core/IO/MeshIO.hh>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

#include <limits>
#include <locale>
#include <sstream>

#include "openmesh_session.h"

namespace dirichlet {
namespace {

using namespace OpenMesh;

/// Takes what a reader of OpenMesh finds straight into arrays. A half-edge mesh in its place would refuse the faces
/// that are not manifold.
class ArrayImporter final : public IO::BaseImporter {
 public:
  explicit ArrayImporter(MeshArrays& arrays) : arrays_(arrays) {}

  VertexHandle add_vertex(const Vec3f& p) override {
    arrays_.positions.insert(arrays_.positions.end(), {p[0], p[1], p[2]});
    return VertexHandle(static_cast<int>(n_vertices()) - 1);
  }
  VertexHandle add_vertex() override { return add_vertex(Vec3f(0.0F)); }
  FaceHandle add_face(const VHandles& corners) override {
    for (const VertexHandle v : corners) arrays_.corners.push_back(v.idx());
    arrays_.offsets.push_back(static_cast<Index>(arrays_.corners.size()));
    return FaceHandle(static_cast<int>(n_faces()) - 1);
  }
  std::size_t n_vertices() const override { return arrays_.positions.size() / 3; }
  std::size_t n_faces() const override { return arrays_.offsets.size() - 1; }
  std::size_t n_edges() const override { return 0; }

  // The rest of what a file may hold is not asked for.
  HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
  FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
  void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
  void set_face_texindex(FaceHandle, int) override {}
  void set_point(VertexHandle, const Vec3f&) override {}
  void set_halfedge(VertexHandle, HalfedgeHandle) override {}
  void set_normal(VertexHandle, const Vec3f&) override {}
  void set_normal(VertexHandle, const Vec3d&) override {}
  void set_normal(FaceHandle, const Vec3f&) override {}
  void set_normal(FaceHandle, const Vec3d&) override {}
  void set_color(VertexHandle, const Vec3uc&) override {}
  void set_color(VertexHandle, const Vec4uc&) override {}
  void set_color(VertexHandle, const Vec3f&) override {}
  void set_color(VertexHandle, const Vec4f&) override {}
  void set_color(EdgeHandle, const Vec3uc&) override {}
  void set_color(EdgeHandle, const Vec4uc&) override {}
  void set_color(EdgeHandle, const Vec3f&) override {}
  void set_color(EdgeHandle, const Vec4f&) override {}
  void set_color(FaceHandle, const Vec3uc&) override {}
  void set_color(FaceHandle, const Vec4uc&) override {}
  void set_color(FaceHandle, const Vec3f&) override {}
  void set_color(FaceHandle, const Vec4f&) override {}
  void set_texcoord(VertexHandle, const Vec2f&) override {}
  void set_texcoord(VertexHandle, const Vec3f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
  void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
  void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
  void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
  void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
  void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
  void set_next(HalfedgeHandle, HalfedgeHandle) override {}
  void set_face(HalfedgeHandle, FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void add_texture_information(int, std::string) override {}

 private:
  MeshArrays& arrays_;
};

} // namespace

MeshArrays read_with_openmesh(std::string_view file_name, const std::string& ending, CheckedFile&& checked) {
  if (checked.corners > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw InputError(message(file_name, " has more corners than can be counted in 32 bits"));
  MeshArrays arrays{std::move(checked.positions), {0}, {}};
  arrays.offsets.reserve(checked.faces + 1);
  arrays.corners.reserve(checked.corners);

  ArrayImporter importer(arrays);
  std::istringstream stream(std::move(checked.stream), std::ios::in | std::ios::binary);
  stream.imbue(std::locale::classic());
  IO::Options options;
  if (checked.binary) options += IO::Options::Binary;
  const OpenMeshSession session;
  if (!IO::IOManager().read(stream, ending, importer, options) || importer.n_faces() != checked.faces ||
      arrays.corners.size() != checked.corners)
    throw InputError(message(file_name, ": OpenMesh finds ", importer.n_faces(), " faces with ", arrays.corners.size(),
                             " corners where ", checked.faces, " with ", checked.corners, " should be"));
  return arrays;
}

} // namespace dirichlet
