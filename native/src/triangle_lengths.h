// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "dirichlet/buffer.h"
#include "dirichlet/mesh.h"

namespace dirichlet {

/// The lengths of a triangle's sides: side i runs from corner i to the next, opposite to the corner before.
using Sides = std::array<double, 3>;

/// Heron's formula in Kahan's order ("Miscalculating Area and Angles of a Needle-like Triangle", 2014): as exact as the
/// lengths are, however thin. 0 where they make no triangle.
double triangle_area(const Sides& sides);

/// ½ cot of the angle opposite to each side, of any scale; above 0 for all but the longest. Infinite or NaN where the
/// area is 0: see mollification.
Sides half_cotangents(const Sides& sides);

/// The smallest length that, added to all three, makes a triangle of them in which the longest side falls short of the
/// sum of the others by 1e-12 of itself; 0 where it does already, and where all three are 0.
double mollification(const Sides& sides);

/// A triangle near by that has an area: each side longer by its mollification, or equilateral where all are 0.
Sides mollified(const Sides& sides);

/// The lengths of a mesh in a unit in which its bounding box is about 1 wide, so that products of several neither
/// vanish nor overflow.
struct SideLengths {
  Buffer<double> lengths;   ///< (C,) from every corner to the next; of an edge the same in all its faces, bit for bit
  double unit = 1;          ///< a power of two: lengths × unit are those of the mesh
  double mollification = 0; ///< the largest of all triangles': added to every length, it leaves none without area
  std::ptrdiff_t mollified = 0; ///< triangles that ask for one, or have no extent at all

  [[nodiscard]] Sides of(Index face) const;
};

/// \param triangles  a mesh of triangles. Cost: O(C), all cores on large meshes.
/// Source of the idea: Sharp, Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020, section 4.5; relative to
/// every triangle's own size instead of the mean length.
SideLengths measure_sides(const Mesh& triangles);

} // namespace dirichlet
