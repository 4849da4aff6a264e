// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh_io/text_scanner.h"

namespace dirichlet {

/// What a check makes of a file that is not damaged.
///
/// OpenMesh's readers (9 to 11) take a damaged file for a shorter one, narrow coordinates to float, drop a vertex that
/// does not fit, and know less of each format than is in use. So a check walks the file before them: it refuses damage
/// with its place, keeps the coordinates in double, and copies the faces into the plainest dialect of the format.
struct CheckedFile {
  std::vector<double>
      positions;         ///< (V, 3); empty for STL, whose corners OpenMesh joins, in the float they are stored in
  std::string stream;    ///< the faces, for OpenMesh's reader of the same format
  bool binary = false;   ///< the stream is in the format's binary form, where OpenMesh has to be told
  std::size_t faces = 0; ///< what OpenMesh has to find in it
  std::size_t corners = 0;
};

/// Each walks the file once. \throws InputError  the first damage: file, line (text) or byte (binary), what is wrong.
/// Cost: O(file), memory too, whatever the file promises.
CheckedFile check_obj(const FileBytes& file);
CheckedFile check_off(const FileBytes& file);
CheckedFile check_ply(const FileBytes& file);
CheckedFile check_stl(const FileBytes& file);

} // namespace dirichlet
