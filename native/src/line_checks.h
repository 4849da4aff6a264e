// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dirichlet/isolines.h"

namespace dirichlet {

/// \throws InputError  arrays that do not fit together, a line of fewer than two points, a point that is not finite
void check_lines(const Isolines& lines);

/// As above, and for lines that are to stay on their edges. \throws InputError  no edges, an edge without both of its
/// vertices, a t outside [0, 1]
void check_edges(const Isolines& lines, Index vertex_count);

} // namespace dirichlet
