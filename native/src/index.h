// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "dirichlet/array.h"

namespace dirichlet {

/// An index as the standard containers count.
constexpr std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// The next corner of the same triangle, in a mesh of triangles.
constexpr Index next_in_triangle(Index corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

} // namespace dirichlet
