// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "dirichlet/mesh_io.h"
#include "mesh_io/checked_file.h"

namespace dirichlet {

/// Has OpenMesh read a checked file of the format with the given ending (".obj").
/// \throws InputError  OpenMesh found other faces than the check did
MeshArrays read_with_openmesh(std::string_view file_name, const std::string& ending, CheckedFile&& checked);

} // namespace dirichlet
