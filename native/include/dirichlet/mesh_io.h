// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "dirichlet/array.h"

namespace dirichlet {

/// The content of a mesh file, ready for Mesh.
struct MeshArrays {
  std::vector<double> positions; ///< (V, 3)
  std::vector<Index> offsets;    ///< (F + 1,)
  std::vector<Index> corners;    ///< (C,)
};

/// Reads OBJ, PLY (text or binary), OFF or STL (text or binary), told apart by the file's ending.
///
/// A strict check of our own walks the file first; OpenMesh then parses its faces, into arrays and not into half-edges,
/// so that non-manifold ones are kept. Coordinates of OBJ, PLY and OFF are the check's, in double, since OpenMesh
/// narrows them to float. STL is OpenMesh's altogether, in float: corners equal in coordinates are joined, and
/// triangles that this shrinks to an edge are dropped. \throws InputError  unreadable, unknown ending, damaged or
/// truncated: names the file and the line (or byte). Memory in proportion to the file, whatever its header promises.
/// Cost: O(file).
MeshArrays read_mesh_file(const std::filesystem::path& path);

/// Writes OBJ, PLY, OFF or STL, by the ending. All but STL (binary, in float and triangles) read back bit for bit what
/// a Mesh has; PLY is binary and carries `colors` when given. \param colors  (V, 3) in 0 … 255, or empty. Written
/// beside the target, then renamed: an error leaves what was there. \throws InputError  unwritable, unknown ending,
/// colours for a format that has none, positions, offsets and corners that are out of range as for Mesh, faces of
/// fewer than three corners (one that names a vertex twice is written), and STL of whose triangles single precision
/// leaves none. \throws TopologyError  STL of a polygon without a triangulation.
void write_mesh_file(const std::filesystem::path& path, std::span<const double> positions,
                     std::span<const Index> offsets, std::span<const Index> corners,
                     std::span<const unsigned char> colors = {});

} // namespace dirichlet
