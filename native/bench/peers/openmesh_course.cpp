// SPDX-License-Identifier: GPL-3.0-or-later
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <memory>
#include <stdexcept>

#include "array_file.h"
#include "courses.h"

namespace peers {

void run_openmesh_course(const std::filesystem::path& scene, const Recorder& recorder) {
  using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
  const auto positions = read_reals(scene / "positions.npy");
  const auto faces = read_indices(scene / "faces.npy");
  const std::size_t vertices = positions.size() / 3;
  recorder.repeat([&](int) {
    const auto mesh = std::make_unique<HalfEdges>();
    recorder.time("connectivity", [&] {
      mesh->reserve(vertices, vertices + faces.size() / 3, faces.size() / 3);
      for (std::size_t v = 0; v < vertices; ++v)
        mesh->add_vertex({positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]});
      const auto corner = [&](std::size_t c) { return HalfEdges::VertexHandle(faces[c]); };
      for (std::size_t c = 0; c < faces.size(); c += 3) mesh->add_face(corner(c), corner(c + 1), corner(c + 2));
    });
    if (3 * mesh->n_faces() != faces.size()) throw std::runtime_error("OpenMesh refuses a face");
  });
}

} // namespace peers
