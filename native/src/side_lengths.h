// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "dirichlet/buffer.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// Lengths such that every triangle has an area and no side is below about 1e-13 of its longest; in a unit in which the
/// mesh is about 1 wide, so that products of several neither vanish nor overflow.
struct SideLengths {
  Buffer<double> lengths; ///< (C,) from every corner to the next; of an edge the same in all its faces, bit for bit
  /// (V,) 1 where all sides that end there are longer than in space; or nothing where none is. Such are the vertices of
  /// triangles that are flat (an angle within about 5e-7 of π), such needles, or points. Longer by the least that is
  /// enough; in pieces that are one point the unit is arbitrary.
  Buffer<std::uint8_t> lengthened;
  Index thickened = 0; ///< triangles that are not flat, but too thin for lengths to tell: their sides were lengthened
};

/// \param triangles  a mesh of triangles
/// Cost: O(C) on all cores, with k vertices to lengthen at O(C + k log k).
/// Source of the idea: intrinsic mollification in Sharp, Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020,
/// which lengthens all sides by the same.
SideLengths mollified_sides(const Mesh& triangles);

} // namespace dirichlet
