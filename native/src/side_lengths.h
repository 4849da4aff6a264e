// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/buffer.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// (C,) the length from every corner to the next, such that every triangle has an area and no side is below about 1e-8
/// of its longest; in a unit in which the mesh is about 1 wide, so that products of several neither vanish nor
/// overflow. Of an edge the same in all its faces, bit for bit.
///
/// These are the lengths in space but at vertices of triangles that are flat (an angle within about 1e-6 of π), such
/// needles, or points: all sides that end there become longer, the least that is enough. In pieces that are one point
/// the unit is arbitrary.
///
/// \param triangles  a mesh of triangles
/// Cost: O(C) on all cores, with k vertices to lengthen at O(C + k log k).
/// Source of the idea: intrinsic mollification in Sharp, Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020,
/// which lengthens all sides by the same.
Buffer<double> mollified_sides(const Mesh& triangles);

} // namespace dirichlet
