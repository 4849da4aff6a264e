// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "dirichlet/array.h"

namespace dirichlet {

/// A polygon mesh to be written: as in write_mesh_file.
struct MeshView {
  std::span<const double> positions;
  std::span<const Index> offsets;
  std::span<const Index> corners;

  [[nodiscard]] std::size_t vertex_count() const { return positions.size() / 3; }
  [[nodiscard]] std::size_t face_count() const { return offsets.size() - 1; }
  [[nodiscard]] std::span<const Index> face(std::size_t f) const {
    const auto begin = static_cast<std::size_t>(offsets[f]);
    return corners.subspan(begin, static_cast<std::size_t>(offsets[f + 1]) - begin);
  }
};

/// The bytes of a file. We write them ourselves: OpenMesh's writers (9 to 11) narrow coordinates to float, and count
/// the corners of a PLY face in one byte whatever their number. Coordinates are written so that reading gives the same
/// doubles, but for STL, which holds floats.
std::string encode_obj(const MeshView& mesh);
std::string encode_off(const MeshView& mesh);
std::string encode_ply(const MeshView& mesh, std::span<const unsigned char> colors); ///< binary
std::string encode_stl(const MeshView& mesh); ///< binary; in triangles. \throws InputError  beyond single precision

} // namespace dirichlet
