// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh_makers.h"
#include "script.h"

namespace dirichlet::fuzz {

/// Adds the surface that a letter names, in the size that the script goes on to say:
///   g nx ny  grid of triangles     q nx ny  grid of quads     t nu nv  torus     k nu nv  Klein bottle
///   s rings sectors  sphere        m n  Möbius band           b pages n  book    h  tetrahedron
///   v x y z  vertex                f n v …  face of n corners, that are there or not
/// \returns false where the letter names none
bool add_surface(makers::PolygonSoup& soup, char letter, Script& script);

/// Damages a soup as the letter says, at places that the script goes on to name:
///   D f  face twice                R f  face turned over           O f  face left out         V f  corners begin later
///   E f c  corner twice in a row   W f c  two corners change place  C f c  corner cut loose (seam)
///   F f c v  one more face on an edge                              J f g  two faces with an edge in common made one
///   M v w  one vertex for both     Z v w  moved onto another       N v w  moved to 1e-12 of the way beside another
///   X v x  spike                   K v w u  moved between two others   S x  all scaled   A a x  one axis scaled
///   T a x  all moved along an axis Y v w  two vertices change places
/// \returns false where the letter names none
bool damage(makers::PolygonSoup& soup, char letter, Script& script);

} // namespace dirichlet::fuzz
